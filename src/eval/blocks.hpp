// Evaluates many vertices: a register program runs over blocks of vertices, four at a time in a
// SIMD register, so that memory depends on the program and not on the mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "eval/lanes_math.hpp"
#include "eval/registers.hpp"

namespace warpjet {

// An input: `size` floats per vertex, or `size` floats in total if it is uniform.
struct Stream {
  const float* values;
  std::uint32_t size;
  bool isUniform;
};

// The destination of results: `size` floats per vertex.
struct Sink {
  float* values;
  std::uint32_t size;
};

// Evaluates a register program. Its results, which are numbers, fill the sinks in order.
class BlockEvaluator {
 public:
  // Uniform inputs are read here, the others in each run.
  BlockEvaluator(RegisterProgram program, std::span<const Stream> inputs);

  void run(std::size_t vertices, std::span<const Stream> inputs, std::span<const Sink> results);

 private:
  // The stream and component of an input number.
  struct Source {
    std::uint32_t stream, component;
  };

  Lanes* lanesOf(Register r);
  void execute(const RegisterInstruction& instruction, std::size_t lanes);
  void load(const Stream& stream, std::uint32_t component, std::size_t first, std::size_t vertices,
            Lanes* result) const;
  void store(Register r, const Sink& sink, std::uint32_t component, std::size_t first,
             std::size_t vertices);

  RegisterProgram program_;
  std::vector<Source> sources_;
  std::vector<Lanes> uniforms_, block_;
  std::size_t lanesPerBlock_;
};

}  // namespace warpjet
