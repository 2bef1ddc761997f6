#include "mesh/stl/stl.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include "mesh/messages.hpp"
#include "mesh/stl/facets.hpp"
#include "mesh/text/encoding.hpp"
#include "mesh/text/lines.hpp"

namespace warpjet {

namespace {

// A header of 80 bytes and a count; then a normal, three corners and two bytes per triangle.
constexpr std::size_t headerSize = 80, start = 84, facetSize = 50;

template <typename T>
T valueAt(Bytes bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

glm::vec3 vectorAt(Bytes bytes, std::size_t at) {
  return {valueAt<float>(bytes, at), valueAt<float>(bytes, at + 4), valueAt<float>(bytes, at + 8)};
}

std::uint64_t sizeInHeader(Bytes bytes) {
  return start + std::uint64_t{facetSize} * valueAt<std::uint32_t>(bytes, headerSize);
}

// Compares words case-insensitively; `word` is lowercase.
bool isWord(std::string_view text, std::string_view word) {
  return std::equal(text.begin(), text.end(), word.begin(), word.end(), [](char c, char lower) {
    return (c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) == lower;
  });
}

// Keywords and numbers of a text, independent of its line breaks.
class Words {
 public:
  explicit Words(std::string_view text) : lines_(text, "stl"), line_(lines_.next()) {}

  // Returns the next word; empty at the end of the text.
  std::string_view next() {
    while (line_) {
      if (const std::string_view word = line_->word(); !word.empty()) return word;
      line_ = lines_.next();
    }
    return {};
  }

  void expect(std::string_view keyword) {
    const std::string_view word = requireWord();
    if (!isWord(word, keyword)) failAt(word, keyword);
  }

  glm::vec3 vector() {
    glm::vec3 v;
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = requireWord();
      v[i] = line_->parseNumber(word);
    }
    return v;
  }

  // Skips the rest of this line, such as the name of a solid.
  void skipLine() { line_ = lines_.next(); }

  [[noreturn]] void failAt(std::string_view word, std::string_view keyword) const {
    line_->fail("has " + quoteText(word) + " where " + quoteText(keyword) + " belongs");
  }

 private:
  std::string_view requireWord() {
    const std::string_view word = next();
    if (word.empty())
      throw FileProblem("the .stl ends in the middle of a facet; export or download it again.");
    return word;
  }

  TextLines lines_;
  std::optional<TextLine> line_;
};

// Parses a facet, whose keyword "facet" has been read.
void readFacet(Words& words, Facets& facets) {
  words.expect("normal");
  const glm::vec3 normal = words.vector();
  words.expect("outer");
  words.expect("loop");
  std::array<glm::vec3, 3> corners;
  for (glm::vec3& corner : corners) {
    words.expect("vertex");
    corner = words.vector();
  }
  words.expect("endloop");
  words.expect("endfacet");
  facets.add(normal, corners);
}

}  // namespace

bool hasStlSize(Bytes bytes) {
  return bytes.size() >= start && sizeInHeader(bytes) == bytes.size();
}

bool isBinaryStl(Bytes bytes) {
  if (bytes.size() < start) return false;
  if (hasStlSize(bytes)) return true;
  const std::string_view text = textOf(bytes);
  if (text.find('\0') == text.npos) return false;
  if (isWord(text.substr(0, 5), "solid")) return true;
  const auto isHeaderText = [](char c) {
    return c == 0 || (c >= '\t' && c <= '\r') || (c >= ' ' && c <= '~');
  };
  if (!std::all_of(text.begin(), text.begin() + headerSize, isHeaderText)) return false;
  if (bytes.size() < start + 12) return sizeInHeader(bytes) > start;
  const glm::vec3 normal = vectorAt(bytes, start);
  const double length = std::hypot(normal.x, normal.y, normal.z);
  return length == 0 || std::abs(length - 1) < 0.01;
}

bool isTextStl(std::string_view text) {
  return isWord(text.substr(0, 5), "solid") && (text.size() == 5 || text[5] <= ' ');
}

Mesh meshOfTextStl(std::string_view text, std::vector<std::string>& warnings) {
  Facets facets;
  // Keywords and spaces alone make a facet at least this long.
  facets.reserve(text.size() / 80);
  Words words(text);
  words.expect("solid");
  words.skipLine();
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (isWord(word, "facet"))
      readFacet(words, facets);
    else if (isWord(word, "endsolid") || isWord(word, "end") || isWord(word, "solid"))
      words.skipLine();
    else
      words.failAt(word, "facet");
  }
  return facets.takeMesh(warnings);
}

Mesh meshOfBinaryStl(Bytes bytes, std::vector<std::string>& warnings) {
  const std::uint64_t size = sizeInHeader(bytes);
  if (size > bytes.size())
    throw FileProblem("the file ends in the middle of its data (expected " + groupDigits(size) +
                      " bytes, got " + groupDigits(bytes.size()) +
                      "); export or download it again.");
  // The colors of Materialise Magics.
  if (textOf(bytes).substr(0, headerSize).find("COLOR=") != std::string_view::npos)
    warnings.push_back("The colours of the .stl are left out.");
  Facets facets;
  facets.reserve((size - start) / facetSize);
  for (std::size_t at = start; at < size; at += facetSize)
    facets.add(vectorAt(bytes, at),
               {vectorAt(bytes, at + 12), vectorAt(bytes, at + 24), vectorAt(bytes, at + 36)});
  return facets.takeMesh(warnings);
}

}  // namespace warpjet
