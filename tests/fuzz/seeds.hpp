// The seeds of the fuzz targets: one small file per feature.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace warpjet {

// Writes a file to the folder of a target, "mesh" or "graph".
void writeSeed(const std::string& target, const std::string& name,
               const std::vector<std::uint8_t>& bytes);

void writeMeshSeeds();
void writeGraphSeeds();

}  // namespace warpjet
