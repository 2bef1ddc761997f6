#include "eval/code_writer.hpp"

#include <algorithm>

namespace warpjet {

namespace {

constexpr std::uint32_t lanesCount = Lanes::count, floatBytes = sizeof(float);

CodeWriter& writer() { return *CodeWriter::current; }

}  // namespace

Staged::Staged(double x) : place(writer().number(x).place) {}

Staged staged(wasm::Simd instruction, Staged x) { return writer().apply(instruction, {x}); }
Staged staged(wasm::Simd instruction, Staged x, Staged y) {
  return writer().apply(instruction, {x, y});
}
Staged staged(wasm::Simd instruction, Staged x, Staged y, Staged z) {
  return writer().apply(instruction, {x, y, z});
}
Staged shiftBits(wasm::Simd instruction, Staged x, int count) {
  return writer().shift(instruction, x, count);
}
Staged routine(Op op, Staged x) { return writer().callRoutine(op, {x}); }
Staged routine(Op op, Staged x, Staged y) { return writer().callRoutine(op, {x, y}); }
Staged kernel(Op op, Staged x) { return writer().callKernel(op, {x}); }
Staged kernel(Op op, Staged x, Staged y) { return writer().callKernel(op, {x, y}); }

Staged routineFormula(Op op, Staged x, Staged y) {
  if (op == ops::find("hash")) return ops::hashOf(x, y);
  // The sine of numbers too large for its formula is computed for each lane.
  const Staged magnitude = abs(x);
  const Staged near = op == ops::find("sin") ? flipSign(sineUpToLimit(magnitude), signOf(x))
                                             : cosineUpToLimit(magnitude);
  return writer().replaceLanes(logicalNot(le(magnitude, sineLimit)), near, op, x);
}

std::uint32_t CodeModule::constant(std::uint32_t bits) {
  const auto first = shared.begin() + static_cast<std::ptrdiff_t>(firstConstant);
  const auto found = std::find(first, shared.end(), bits);
  const auto index = static_cast<std::uint32_t>(found - shared.begin());
  if (found == shared.end()) shared.push_back(bits);
  return index;
}

Staged CodeWriter::number(double x) {
  const auto bits = __builtin_bit_cast(std::uint32_t, static_cast<float>(x));
  return Staged(module_.constant(bits) | Staged::sharedFlag);
}

Staged CodeWriter::apply(wasm::Simd instruction, std::initializer_list<Staged> operands) {
  for (const Staged x : operands) push(x);
  simd(instruction);
  return pop();
}

Staged CodeWriter::shift(wasm::Simd instruction, Staged x, int count) {
  push(x);
  code_.byte(wasm::Number);
  code_.signedNumber(count);
  simd(instruction);
  return pop();
}

Staged CodeWriter::callRoutine(Op op, std::initializer_list<Staged> operands) {
  if (module_.routines[index(op)] == noFunction)
    return routineFormula(op, *operands.begin(), *(operands.end() - 1));
  get(0);
  for (const Staged x : operands) push(x);
  call(module_.routines[index(op)]);
  return pop();
}

Staged CodeWriter::callKernel(Op op, std::initializer_list<Staged> operands) {
  for (const Staged x : operands) push(x);
  call(module_.kernels[index(op)]);
  return pop();
}

Staged CodeWriter::callEachLane(Op op, const Operands<Staged>& x) {
  code_.byte(wasm::Number);
  code_.signedNumber(static_cast<std::int32_t>(index(op)));
  for (int k = 0; k < ops::maxArity; ++k) push(x[k < arities[index(op)] ? k : 0]);
  call(module_.eachLane);
  return pop();
}

Staged CodeWriter::replaceLanes(StagedMask mask, Staged value, Op op, Staged x) {
  push(asLanes(mask));
  simd(wasm::AnyTrue);
  code_.byte(wasm::If);
  code_.byte(wasm::noResult);
  isInBranch_ = true;
  const Staged other = callEachLane(op, {x, x, x});
  push(ifElse(mask, other, value));
  code_.byte(wasm::LocalSet);
  code_.number(value.place);
  code_.byte(wasm::End);
  isInBranch_ = false;
  return value;
}

Staged CodeWriter::load(std::uint32_t offset, std::uint32_t size, std::uint32_t component) {
  computeAddress(size);
  for (std::uint32_t lane = 0; lane < lanesCount; ++lane) get(address_);
  for (std::uint32_t lane = 0; lane < lanesCount; ++lane) {
    const auto address = static_cast<int>(offset + floatBytes * (lane * size + component));
    simd(lane == 0 ? wasm::LoadFirst : wasm::LoadLane, address);
    if (lane > 0) code_.byte(static_cast<std::uint8_t>(lane));
  }
  return pop();
}

void CodeWriter::store(Staged x, std::uint32_t offset, std::uint32_t size,
                       std::uint32_t component) {
  computeAddress(size);
  for (std::uint32_t lane = 0; lane < lanesCount; ++lane) {
    get(address_);
    push(x);
    simd(wasm::StoreLane, static_cast<int>(offset + floatBytes * (lane * size + component)));
    code_.byte(static_cast<std::uint8_t>(lane));
  }
}

Staged CodeWriter::loadOne(std::uint32_t offset) {
  get(0);
  simd(wasm::LoadSplat, static_cast<int>(offset));
  return pop();
}

void CodeWriter::storeOne(Staged x, std::uint32_t offset) {
  get(0);
  push(x);
  simd(wasm::StoreLane, static_cast<int>(offset));
  code_.byte(0);
}

Staged CodeWriter::loadFour(std::uint32_t offset) {
  get(0);
  simd(wasm::Load, static_cast<int>(offset));
  return pop();
}

void CodeWriter::storeFour(Staged x, std::uint32_t offset) {
  get(0);
  push(x);
  simd(wasm::Store, static_cast<int>(offset));
}

Staged CodeWriter::copyToOwnLocal(Staged x) {
  if (std::find(taken_.begin(), taken_.end(), x.place) != taken_.end()) return x;
  push(x);
  return pop();
}

void CodeWriter::releaseAllBut(Staged x) {
  for (const std::uint32_t local : taken_) {
    if (local != x.place) free_.push_back(local);
  }
  taken_.clear();
}

WasmBytes CodeWriter::function() const {
  WasmBytes body;
  body.number(2);
  body.number(1);
  body.byte(wasm::i32);
  body.number(locals_);
  body.byte(wasm::v128);
  body.append(code_);
  body.byte(wasm::End);
  return body;
}

// Loads a shared number only once per function: V8 keeps the order of loads, and would start with
// all of them, and then spill most of them, if each use were a load.
void CodeWriter::push(Staged x) {
  if ((x.place & Staged::sharedFlag) == 0) return get(x.place);
  const std::uint32_t number = x.place & ~Staged::sharedFlag;
  const auto known = sharedLocals_.find(number);
  if (known != sharedLocals_.end()) return get(known->second);
  get(0);
  simd(wasm::LoadSplat, static_cast<int>(module_.sharedAt + floatBytes * number));
  if (isInBranch_) return;
  const std::uint32_t local = addLocal();
  sharedLocals_[number] = local;
  code_.byte(wasm::LocalTee);
  code_.number(local);
}

// Pops the stack into a local.
Staged CodeWriter::pop() {
  std::uint32_t local;
  if (free_.empty()) {
    local = addLocal();
  } else {
    local = free_.back();
    free_.pop_back();
  }
  taken_.push_back(local);
  code_.byte(wasm::LocalSet);
  code_.number(local);
  return Staged(local);
}

// Instructions that access memory have an offset; it is a multiple of four bytes.
void CodeWriter::simd(wasm::Simd instruction, int offset) {
  code_.byte(0xfd);
  code_.number(instruction);
  if (offset < 0) return;
  code_.byte(2);
  code_.number(static_cast<std::uint32_t>(offset));
}

void CodeWriter::get(std::uint32_t local) {
  code_.byte(wasm::LocalGet);
  code_.number(local);
}

void CodeWriter::call(std::uint32_t function) {
  code_.byte(wasm::Call);
  code_.number(function);
}

void CodeWriter::computeAddress(std::uint32_t size) {
  get(0);
  get(1);
  code_.byte(wasm::Number);
  code_.signedNumber(static_cast<std::int32_t>(size));
  code_.byte(wasm::Multiply);
  code_.byte(wasm::Add);
  code_.byte(wasm::LocalSet);
  code_.number(address_);
}

}  // namespace warpjet
