// Writes all seeds: `fuzz_seeds FOLDER`.
#include "fuzz/seeds.hpp"

#include <filesystem>
#include <fstream>

namespace warpjet {

namespace {

std::filesystem::path folder;

}  // namespace

void writeSeed(const std::string& target, const std::string& name,
               const std::vector<std::uint8_t>& bytes) {
  std::filesystem::create_directories(folder / target);
  std::ofstream file(folder / target / name, std::ios::binary);
  file.exceptions(std::ios::failbit | std::ios::badbit);
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

}  // namespace warpjet

int main(int count, char** arguments) {
  if (count != 2) return 1;
  warpjet::folder = arguments[1];
  warpjet::writeMeshSeeds();
  warpjet::writeGraphSeeds();
  return 0;
}
