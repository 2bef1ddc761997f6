#include "fuzz/gltf_mutator.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <string>

namespace warpjet {

namespace {

using nlohmann::json;
using Random = std::minstd_rand;

constexpr std::size_t headerSize = 12, chunkHeaderSize = 8;

std::size_t below(Random& random, std::size_t n) { return random() % n; }

struct Glb {
  std::string text;
  FileBytes binary;
};

std::size_t wordAt(const FileBytes& file, std::size_t at) {
  return file[at] | file[at + 1] << 8 | file[at + 2] << 16 | std::size_t{file[at + 3]} << 24;
}

void append(FileBytes& file, std::size_t word) {
  for (int shift = 0; shift < 32; shift += 8)
    file.push_back(static_cast<std::uint8_t>(word >> shift));
}

// Parses a GLB. If its lengths exceed the file, parses up to the end of the file.
std::optional<Glb> parseGlb(const FileBytes& file) {
  constexpr std::size_t start = headerSize + chunkHeaderSize;
  if (file.size() < start || !std::equal(file.begin(), file.begin() + 4, "glTF")) return {};
  const auto text = file.begin() + start;
  const std::size_t length = std::min(wordAt(file, headerSize), file.size() - start);
  const auto end = text + static_cast<std::ptrdiff_t>(length);
  Glb glb{{text, end}, {}};
  if (file.end() - end >= static_cast<std::ptrdiff_t>(chunkHeaderSize))
    glb.binary.assign(end + chunkHeaderSize, file.end());
  return glb;
}

FileBytes writeGlb(Glb glb) {
  glb.text.resize((glb.text.size() + 3) / 4 * 4, ' ');
  glb.binary.resize((glb.binary.size() + 3) / 4 * 4);
  FileBytes file{'g', 'l', 'T', 'F'};
  const std::size_t binarySize = glb.binary.empty() ? 0 : chunkHeaderSize + glb.binary.size();
  append(file, 2);
  append(file, headerSize + chunkHeaderSize + glb.text.size() + binarySize);
  append(file, glb.text.size());
  append(file, 0x4E4F534A);
  file.insert(file.end(), glb.text.begin(), glb.text.end());
  if (glb.binary.empty()) return file;
  append(file, glb.binary.size());
  append(file, 0x004E4942);
  file.insert(file.end(), glb.binary.begin(), glb.binary.end());
  return file;
}

// Parses JSON that is shallow enough for recursion; nullopt otherwise.
std::optional<json> parseShallow(const std::string& text) {
  const auto isShallow = [](int depth, json::parse_event_t, json&) { return depth < 40; };
  json tree = json::parse(text, isShallow, false);
  if (!tree.is_structured()) return {};
  return tree;
}

void collect(json& tree, std::vector<json*>& values) {
  for (json& value : tree) {
    values.push_back(&value);
    if (value.is_structured()) collect(value, values);
  }
}

// Returns one of the values that are known to break readers of files.
json oddValue(Random& random) {
  static const std::array<json, 24> values = {nullptr,
                                              true,
                                              false,
                                              -1,
                                              0,
                                              1,
                                              2,
                                              3,
                                              4,
                                              255,
                                              65535,
                                              65536,
                                              2147483647u,
                                              4294967295u,
                                              1e300,
                                              0.5,
                                              5121,
                                              5125,
                                              1073741823,
                                              4294967296u,
                                              "",
                                              "VEC3",
                                              json::array(),
                                              json::object()};
  return values[below(random, values.size())];
}

// Makes one change to one value.
void changeOneValue(json& tree, Random& random) {
  std::vector<json*> values;
  collect(tree, values);
  if (values.empty()) return;
  json& value = *values[below(random, values.size())];
  switch (below(random, 6)) {
    case 0:
      value = oddValue(random);
      break;
    case 1: {
      const json copy = *values[below(random, values.size())];
      value = copy;
      break;
    }
    case 2:
      if (value.is_number_integer())
        value = value.get<std::int64_t>() + static_cast<std::int64_t>(below(random, 9)) - 4;
      else if (value.is_number())
        value = value.get<double>() * (static_cast<double>(below(random, 9)) - 4);
      else
        value = oddValue(random);
      break;
    case 3:  // duplicates an element
      if (value.is_array() && !value.empty()) {
        const json copy = value[below(random, value.size())];
        value.push_back(copy);
      }
      break;
    case 4:
      if (value.is_structured() && !value.empty()) {
        auto member = value.begin();
        std::advance(member, below(random, value.size()));
        value.erase(member);
      }
      break;
    default:
      if (value.is_array() && value.size() > 1)
        std::swap(value[below(random, value.size())], value[below(random, value.size())]);
      else
        value = oddValue(random);
  }
}

void mutateText(std::string& text, std::size_t maxSize, Random& random, const MutateBytes& mutate) {
  auto tree = below(random, 8) == 0 ? std::nullopt : parseShallow(text);
  if (tree) {
    for (std::size_t n = 1 + below(random, 3); n > 0; --n) changeOneValue(*tree, random);
    text = tree->dump(-1, ' ', false, json::error_handler_t::replace);
    return;
  }
  FileBytes bytes(text.begin(), text.end());
  mutate(bytes, maxSize);
  text.assign(bytes.begin(), bytes.end());
}

}  // namespace

FileBytes mutateFile(FileBytes file, std::size_t maxSize, unsigned seed,
                     const MutateBytes& mutate) {
  Random random(seed);
  FileBytes mutated = file;
  const bool isText = !file.empty() && file[0] == '{';
  auto glb = parseGlb(file);
  const std::size_t kind = below(random, 16);
  if (glb && kind > 0) {
    if (kind < 5 && !glb->binary.empty()) {
      // The JSON contains the size of the binary chunk.
      const std::size_t size = glb->binary.size();
      mutate(glb->binary, maxSize);
      glb->binary.resize(size);
    } else {
      mutateText(glb->text, maxSize, random, mutate);
    }
    mutated = writeGlb(std::move(*glb));
  } else if (isText && kind > 0) {
    std::string text(file.begin(), file.end());
    mutateText(text, maxSize, random, mutate);
    mutated.assign(text.begin(), text.end());
  } else {
    mutate(mutated, maxSize);
  }
  if (mutated.size() <= maxSize) return mutated;
  mutate(file, maxSize);
  return file;
}

}  // namespace warpjet
