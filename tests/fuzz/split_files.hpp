// Splits an input of the fuzzer into a file and the external files that it refers to.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/load.hpp"

namespace warpjet {

// `bytes` is in memory of exactly its size, so that the sanitizer detects any read outside.
struct SplitFiles {
  std::vector<std::uint8_t> bytes;
  Files externals;
};

// A first byte below 8, with which no file starts, is the number of external files. Each has two
// bytes for its length, the low one first, and its content; the rest is the file, which refers to
// them in that order.
inline SplitFiles splitFiles(std::span<const std::uint8_t> data) {
  std::vector<std::vector<std::uint8_t>> contents;
  if (!data.empty() && data[0] < 8) {
    contents.resize(data[0]);
    data = data.subspan(1);
    for (auto& content : contents) {
      if (data.size() < 2) break;
      const std::size_t length = std::min<std::size_t>(data[0] | data[1] << 8, data.size() - 2);
      content.assign(data.begin() + 2, data.begin() + 2 + static_cast<std::ptrdiff_t>(length));
      data = data.subspan(2 + length);
    }
  }
  SplitFiles split{{data.begin(), data.end()}, {}};
  // An .mtl file refers to further files.
  for (std::size_t i = 0; i < contents.size(); ++i) {
    const std::vector<std::string> uris = externalFiles(split.bytes, split.externals);
    if (i >= uris.size()) break;
    split.externals[uris[i]] = std::move(contents[i]);
  }
  return split;
}

}  // namespace warpjet
