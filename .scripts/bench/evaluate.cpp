// The native program of npm run bench -- evaluate: reads a compiled warp and a mesh, warps the mesh
// twice, and prints how many seconds the second pass took.
#include <chrono>
#include <cstdio>
#include <fstream>
#include <vector>

#include "eval/blocks.hpp"

using namespace warpjet;

template <class T>
std::vector<T> read(std::ifstream& file, std::size_t count) {
  std::vector<T> values(count);
  file.read(reinterpret_cast<char*>(values.data()),
            static_cast<std::streamsize>(count * sizeof(T)));
  return values;
}

int main(int, char** arguments) {
  std::ifstream file(arguments[1], std::ios::binary);
  const auto header = read<std::uint32_t>(file, 4);
  const auto sizes = read<std::uint32_t>(file, header[2]);
  const auto words = read<std::uint32_t>(file, header[0]);
  const std::size_t vertices = read<std::uint32_t>(file, 1)[0];
  const auto positions = read<float>(file, 3 * vertices), normals = read<float>(file, 3 * vertices);
  const auto millis = read<float>(file, 1);
  if (!file) return 1;

  // The inputs of compileWarp: position, normal, the time, and others that these warps do not read.
  const std::vector<float> zeros(16);
  std::vector<Stream> inputs{{positions.data(), 3, false}, {normals.data(), 3, false}};
  for (std::size_t i = 2; i < sizes.size(); ++i)
    inputs.push_back({i == header[3] ? millis.data() : zeros.data(), sizes[i], true});
  std::vector<bool> isUniform;
  for (const Stream& input : inputs) isUniform.insert(isUniform.end(), input.size, input.isUniform);

  std::vector<float> warpedPositions(3 * vertices), warpedNormals(3 * vertices);
  const Sink results[] = {{warpedPositions.data(), 3}, {warpedNormals.data(), 3}};
  const std::uint32_t outputs[] = {0, 1, 2, 3, 4, 5};
  double seconds = 0;
  for (int pass = 0; pass < 2; ++pass) {
    const auto start = std::chrono::steady_clock::now();
    BlockEvaluator(allocateRegisters(words, header[1], outputs, isUniform), inputs)
        .run(vertices, inputs, results);
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  std::printf("%.9f\n", seconds);
}
