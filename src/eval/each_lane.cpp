#include "eval/each_lane.hpp"

#include <array>

namespace warpjet {

namespace {

// Returns the number in lane i. A true condition is stored as -1.
double numberIn(const Lanes& lanes, std::size_t i, ops::Type type) {
  const double bits = asMask(lanes).bits[i];
  return type == ops::Type::Float ? double{lanes[i]} : type == ops::Type::Int ? bits : -bits;
}

float numberAs(ops::Type type, double value) {
  if (type == ops::Type::Float) return static_cast<float>(value);
  const auto whole = static_cast<std::int32_t>(value);
  return __builtin_bit_cast(float, type == ops::Type::Int ? whole : -whole);
}

// A copy of the signatures, so that the program doesn't contain the names of operations.
constexpr auto signatures = [] {
  std::array<ops::Signature, ops::count> all{};
  for (std::size_t i = 0; i < ops::count; ++i) all[i] = ops::declarations[i].signature;
  return all;
}();

}  // namespace

Lanes eachLane(Op op, const Operands<Lanes>& x) {
  const ops::Signature& signature = signatures[index(op)];
  Lanes all;
  for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
    Operands<double> numbers{};
    for (int k = 0; k < arities[index(op)]; ++k)
      numbers[k] = numberIn(x[k], lane, signature.operands[k]);
    all.set(lane, numberAs(signature.result, ops::valueOf(op, numbers)));
  }
  return all;
}

}  // namespace warpjet
