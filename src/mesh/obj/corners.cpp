#include "mesh/obj/corners.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <string_view>

#include "mesh/messages.hpp"

namespace warpjet {

namespace {

// Converts a number of the file, which counts from 1 or, if negative, from the end, to an index;
// `none` if it is outside of the list.
std::uint32_t indexOf(std::int64_t number, std::size_t count) {
  const auto length = static_cast<std::int64_t>(count);
  if (number == 0 || number > length || number < -length) return none;
  return static_cast<std::uint32_t>(number > 0 ? number - 1 : length + number);
}

std::int64_t cornerNumber(const TextLine& line, std::string_view text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    line.fail("has " + quoteText(text) + " where a face's corner belongs");
  return number;
}

}  // namespace

bool readCorners(TextLine& line, const ObjCounts& counts, std::vector<ObjCorner>& corners) {
  corners.clear();
  bool hasAll = true;
  for (std::string_view text = line.word(); !text.empty(); text = line.word()) {
    std::array<std::string_view, 3> parts;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t length = std::min(text.find('/'), text.size());
      parts[i] = text.substr(0, length);
      text.remove_prefix(std::min(length + 1, text.size()));
    }
    const std::int64_t number = cornerNumber(line, parts[0]);
    ObjCorner corner{indexOf(number, counts.positions), none, none};
    if (corner.position == none)
      line.fail("refers to position " + std::to_string(number) + ", but " +
                (counts.positions == 0 ? "there is none"
                                       : "there are only " + groupDigits(counts.positions)) +
                " before it");
    const auto find = [&](std::string_view part, std::size_t count) {
      if (part.empty()) return none;
      const std::uint32_t place = indexOf(cornerNumber(line, part), count);
      hasAll &= place != none;
      return place;
    };
    corner.uv = find(parts[1], counts.uvs);
    corner.normal = find(parts[2], counts.normals);
    corners.push_back(corner);
  }
  return hasAll;
}

std::uint32_t ObjVertices::vertexOf(const ObjCorner& corner) {
  const auto next = static_cast<std::uint32_t>(corners_.size());
  const std::uint64_t hash = mixBits(
      mixBits(std::uint64_t{corner.position} << 32 | corner.uv, corner.normal), corner.color);
  const std::uint32_t vertex = buckets_.findOrAdd(
      hash, next, [&](std::uint32_t other) { return corners_[other] == corner; });
  if (vertex == next) corners_.push_back(corner);
  return vertex;
}

}  // namespace warpjet
