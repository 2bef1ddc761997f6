// Reads the words of a program.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>

#include "graph/graph.hpp"

namespace warpjet {

// Four words per instruction (its operation, then its operands), then one per result.
class Words {
 public:
  static constexpr std::size_t perInstruction = 4;

  Words(std::span<const std::uint32_t> words, std::uint32_t instructions)
      : words_(words), instructions_(instructions) {}

  Op op(std::uint32_t i) const { return Op{static_cast<std::uint8_t>(instruction(i)[0])}; }

  // Returns the instructions that instruction i reads, all of them earlier.
  std::span<const std::uint32_t> operands(std::uint32_t i) const {
    return instruction(i).subspan(1, arities[index(op(i))]);
  }

  // Returns the value of a constant.
  double constant(std::uint32_t i) const {
    double value;
    std::memcpy(&value, &instruction(i)[1], sizeof value);
    return value;
  }

  // Returns the index of an input number.
  std::uint32_t input(std::uint32_t i) const { return instruction(i)[1]; }

  // Returns the instruction of this result.
  std::uint32_t result(std::size_t i) const { return words_[instructions_ * perInstruction + i]; }

  std::uint32_t count() const { return instructions_; }

 private:
  std::span<const std::uint32_t> instruction(std::uint32_t i) const {
    return words_.subspan(i * perInstruction, perInstruction);
  }

  std::span<const std::uint32_t> words_;
  std::uint32_t instructions_;
};

}  // namespace warpjet
