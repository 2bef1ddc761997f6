#include "eval/blocks.hpp"

#include <algorithm>
#include <utility>

#include "eval/each_lane.hpp"
#include "ops/rows.hpp"

namespace warpjet {

namespace {

// The registers of a block should fit into the first-level cache together with the inputs, and the
// work on a block should outweigh the cost of dispatch.
constexpr std::size_t blockBytes = 32 * 1024;
constexpr std::size_t minLanes = 8, maxLanes = 64;

// The address of a register's lanes, and the stride to those of the next four vertices.
struct Place {
  const Lanes* lanes;
  std::size_t step;
};

template <ops::Type type>
auto toOperand(const Lanes& lanes) {
  if constexpr (type == ops::Type::Bool)
    return asMask(lanes);
  else
    return lanes;
}

Lanes toLanes(const Lanes& value) { return value; }
Lanes toLanes(const Mask& value) { return asLanes(value); }

// Evaluates a row of the table on four numbers; rows written for plain numbers are called once for
// each of the four.
template <std::size_t Row, class... X>
auto valueOf(const X&... x) {
  constexpr const auto& row = std::get<Row>(ops::table);
  if constexpr (std::is_invocable_v<decltype(row.value), X...>) {
    return row.value(x...);
  } else {
    static_assert(ops::declarations[Row].signature.result == ops::Type::Float &&
                      (std::is_same_v<X, Lanes> && ...),
                  "a row of conditions must be written for any scalar");
    Lanes all;
    for (std::size_t i = 0; i < Lanes::count; ++i)
      all.set(i, static_cast<float>(row.value(static_cast<double>(x[i])...)));
    return all;
  }
}

// Applies an operation on integers lane by lane. Such operations are rare.
[[gnu::noinline]] void applyEach(Op op, Lanes* result, const Operands<Place>& operands,
                                 std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    Operands<Lanes> x;
    for (int k = 0; k < arities[index(op)]; ++k) x[k] = operands[k].lanes[i * operands[k].step];
    result[i] = eachLane(op, x);
  }
}

template <std::size_t Row>
void applyRow(Lanes* result, const Operands<Place>& operands, std::size_t count) {
  constexpr auto types = ops::declarations[Row].signature.operands;
  ops::withIndices<ops::declarations[Row].arity>([=](auto... k) {
    for (std::size_t i = 0; i < count; ++i)
      result[i] =
          toLanes(valueOf<Row>(toOperand<types[k]>(operands[k].lanes[i * operands[k].step])...));
  });
}

using Kernel = void (*)(Lanes*, const Operands<Place>&, std::size_t);

template <std::size_t Row>
constexpr Kernel kernelOf() {
  if constexpr (ops::declarations[Row].signature.hasInt()) {
    return nullptr;
  } else {
    return &applyRow<Row>;
  }
}

// Null for integer operations.
constexpr auto kernels =
    ops::withIndices<ops::count>([](auto... row) { return std::array{kernelOf<row>()...}; });

}  // namespace

BlockEvaluator::BlockEvaluator(RegisterProgram program, std::span<const Stream> inputs)
    : program_(std::move(program)), uniforms_(program_.uniformRegisters) {
  for (std::uint32_t stream = 0; stream < inputs.size(); ++stream) {
    for (std::uint32_t i = 0; i < inputs[stream].size; ++i) sources_.push_back({stream, i});
  }
  const std::size_t registers = std::max<std::size_t>(program_.blockRegisters, 1);
  lanesPerBlock_ = std::clamp(blockBytes / sizeof(Lanes) / registers, minLanes, maxLanes);
  block_.resize(registers * lanesPerBlock_);

  std::copy(program_.constants.begin(), program_.constants.end(), uniforms_.begin());
  for (const RegisterInstruction& instruction : program_.prologue) {
    if (instruction.op == inputOp) {
      const auto [stream, component] = sources_[instruction.input];
      uniforms_[instruction.result.number] = inputs[stream].values[component];
    } else {
      execute(instruction, 1);
    }
  }
}

Lanes* BlockEvaluator::lanesOf(Register r) {
  return r.isUniform ? &uniforms_[r.number] : &block_[r.number * lanesPerBlock_];
}

void BlockEvaluator::execute(const RegisterInstruction& instruction, std::size_t lanes) {
  Operands<Place> operands{};
  for (int i = 0; i < arities[index(instruction.op)]; ++i) {
    const Register r = instruction.operands[i];
    operands[i] = {lanesOf(r), r.isUniform ? std::size_t{0} : std::size_t{1}};
  }
  Lanes* const result = lanesOf(instruction.result);
  if (const Kernel kernel = kernels[index(instruction.op)]) return kernel(result, operands, lanes);
  applyEach(instruction.op, result, operands, lanes);
}

void BlockEvaluator::run(std::size_t vertices, std::span<const Stream> inputs,
                         std::span<const Sink> results) {
  const std::size_t perBlock = lanesPerBlock_ * Lanes::count;
  for (std::size_t first = 0; first < vertices; first += perBlock) {
    const std::size_t count = std::min(perBlock, vertices - first);
    const std::size_t lanes = (count + Lanes::count - 1) / Lanes::count;
    for (const RegisterInstruction& instruction : program_.body) {
      if (instruction.op == inputOp) {
        const auto [stream, component] = sources_[instruction.input];
        load(inputs[stream], component, first, count, lanesOf(instruction.result));
      } else {
        execute(instruction, lanes);
      }
    }
    auto result = program_.results.begin();
    for (const Sink& sink : results) {
      for (std::uint32_t i = 0; i < sink.size; ++i) store(*result++, sink, i, first, count);
    }
  }
}

// Loads a component of an input. Lanes past the last vertex repeat its value, so that they don't
// contain denormals, for instance, which slow down arithmetic.
void BlockEvaluator::load(const Stream& stream, std::uint32_t component, std::size_t first,
                          std::size_t vertices, Lanes* result) const {
  const std::size_t size = stream.size;
  const float* values = stream.values + first * size + component;
  std::size_t i = 0;
  for (; i + Lanes::count <= vertices; i += Lanes::count, values += Lanes::count * size)
    *result++ = Lanes::Floats{values[0], values[size], values[2 * size], values[3 * size]};
  if (i == vertices) return;
  const std::size_t left = vertices - i;
  for (std::size_t k = 0; k < Lanes::count; ++k)
    result->set(k, values[std::min(k, left - 1) * size]);
}

void BlockEvaluator::store(Register r, const Sink& sink, std::uint32_t component, std::size_t first,
                           std::size_t vertices) {
  const std::size_t size = sink.size, step = r.isUniform ? 0 : 1;
  const Lanes* lanes = lanesOf(r);
  float* values = sink.values + first * size + component;
  std::size_t i = 0;
  for (; i + Lanes::count <= vertices; i += Lanes::count, values += Lanes::count * size) {
    values[0] = (*lanes)[0];
    values[size] = (*lanes)[1];
    values[2 * size] = (*lanes)[2];
    values[3 * size] = (*lanes)[3];
    lanes += step;
  }
  for (std::size_t k = 0; i + k < vertices; ++k) values[k * size] = (*lanes)[k];
}

}  // namespace warpjet
