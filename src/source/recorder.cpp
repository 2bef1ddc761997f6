#include "source/recorder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <unordered_set>

#include "source/fold.hpp"

namespace warpjet::source {

namespace {

// Returns true if a result may be folded. Infinite results are left to the shader, unless an
// operand was already infinite.
bool canFoldTo(double result, bool areFinite) {
  return areFinite ? std::abs(result) <= 3.4028234663852886e38 : !std::isnan(result);
}

std::uint64_t mixBits(std::uint64_t h) {
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
  return h ^ (h >> 31);
}

}  // namespace

double representAs(Base base, double value) {
  switch (base) {
    case Base::Float:
      return static_cast<double>(static_cast<float>(value));
    case Base::Bool:
      return value != 0;
    default: {
      const auto bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(value));
      return base == Base::Int ? static_cast<double>(static_cast<std::int32_t>(bits))
                               : static_cast<double>(bits);
    }
  }
}

bool Recorder::isEqual(Id id, const Operation& operation, std::span<const Id> operands) const {
  const Operation& other = at(id);
  // Compares bits: -0 differs from 0.
  return other.code == operation.code && other.base == operation.base &&
         std::memcmp(&other.value, &operation.value, sizeof other.value) == 0 &&
         std::equal(operands.begin(), operands.end(), this->operands(id).begin(),
                    this->operands(id).end());
}

Id Recorder::intern(Operation operation, std::span<const Id> operands) {
  if (isFull()) return Id(operations_.size() - 1);
  std::uint64_t bits;
  std::memcpy(&bits, &operation.value, sizeof bits);
  std::uint64_t hash = mixBits(bits ^ static_cast<std::uint64_t>(operation.code) << 40 ^
                               static_cast<std::uint64_t>(operation.base) << 48);
  for (const Id operand : operands) hash = mixBits(hash + index(operand) + 1);
  const auto [first, last] = known_.equal_range(hash);
  for (auto found = first; found != last; ++found)
    if (isEqual(found->second, operation, operands)) return found->second;
  operation.first = static_cast<std::uint32_t>(operands_.size());
  operation.count = static_cast<std::uint16_t>(operands.size());
  // Operands may be a part of the list that grows.
  const std::vector<Id> copied(operands.begin(), operands.end());
  operands_.insert(operands_.end(), copied.begin(), copied.end());
  operations_.push_back(operation);
  const Id id{static_cast<std::uint32_t>(operations_.size() - 1)};
  known_.emplace(hash, id);
  return id;
}

Id Recorder::constant(Base base, double value) {
  const double known = representAs(base, value);
  return intern({Code::Constant, base, 0, 0, known}, {});
}

Id Recorder::undefined(Base base) { return intern({Code::Undefined, base}, {}); }

Id Recorder::leaf(Code code, int number, int part, int layout) {
  const Base base = code == Code::Image ? Base::Sampler : Base::Float;
  return intern({code, base, 0, 0, number * 65536.0 + part * 256 + layout}, {});
}

Id Recorder::leafOf(Code code, int number, int part, Type type) {
  const Id low = leaf(code, number, part, type.layout());
  if (type.base != Base::Int && type.base != Base::Uint) return convert(low, type.base);
  const Id high = leaf(code, number, part, type.layout() | highHalf);
  return apply(type.base == Base::Int ? Code::IntOfHalves : Code::UintOfHalves, type.base,
               {low, high});
}

Id Recorder::group(Code code, std::span<const Id> operands) {
  std::vector<Id> known(operands.begin(), operands.end());
  for (Id& operand : known)
    if (isUndefined(operand)) operand = constant(base(operand), 0);
  return intern({code, Base::Float}, known);
}

Id Recorder::component(Code code, Id group, int part, int layout) {
  return intern({code, Base::Float, 0, 0, part * 256.0 + layout}, std::array{group});
}

Id Recorder::call(std::uint32_t routine, std::span<const Id> arguments) {
  std::vector<Id> known(arguments.begin(), arguments.end());
  for (Id& each : known)
    if (isUndefined(each)) each = constant(Base::Float, 0);
  return intern({Code::Call, Base::Float, 0, 0, 1.0 * routine}, known);
}

// Takes time proportional to the number of needed operations, not of recorded ones, since it is
// called for every function of a source.
std::vector<Id> Recorder::neededBy(std::span<const Id> results) const {
  std::unordered_set<std::uint32_t> known;
  std::vector<Id> all;
  const auto add = [&](std::span<const Id> ids) {
    for (const Id id : ids)
      if (known.insert(index(id)).second) all.push_back(id);
  };
  add(results);
  for (std::size_t i = 0; i < all.size(); ++i) add(operands(all[i]));
  std::sort(all.begin(), all.end());
  return all;
}

std::uint32_t Recorder::openLoop(std::uint32_t outer) {
  loops_.push_back({outer});
  return static_cast<std::uint32_t>(loops_.size());
}

Id Recorder::fold(std::uint32_t number, std::uint32_t steps, std::span<const Id> starts,
                  std::span<const Id> nexts) {
  Loop& loop = loops_[number - 1];
  loop.steps = steps;
  if (loop.outer) {
    std::uint32_t& inner = loops_[loop.outer - 1].inner;
    inner = std::max(inner, (loop.isCounted() ? steps : 1) * loop.inner);
  }
  std::vector<Id> operands(starts.begin(), starts.end());
  operands.insert(operands.end(), nexts.begin(), nexts.end());
  return intern({Code::Fold, Base::Float, 0, 0, 1.0 * number}, operands);
}

bool Recorder::isIntegral(Id id) const {
  switch (at(id).code) {
    case Code::Constant:
      return value(id) == std::trunc(value(id));
    case Code::StepNumber:
      return true;
    case Code::Add:
    case Code::Mult:
      return isIntegral(operands(id)[0]) && isIntegral(operands(id)[1]);
    default:
      return false;
  }
}

Id Recorder::apply(Code code, Base base, std::initializer_list<Id> given) {
  std::array<Id, 3> operands{};
  std::array<double, 3> values{};
  std::size_t count = 0;
  bool areKnown = true, areFinite = true;
  for (const Id operand : given) {
    const Id known = isUndefined(operand) ? constant(this->base(operand), 0) : operand;
    operands[count] = known;
    areKnown = areKnown && isConstant(known);
    areFinite = areFinite && !std::isinf(value(known));
    values[count++] = value(known);
  }
  if (areKnown)
    if (const auto result = foldsAll_ ? foldFunction(code, {values.data(), count})
                                      : source::fold(code, {values.data(), count}))
      if (base != Base::Float || canFoldTo(*result, areFinite)) return constant(base, *result);
  if (!foldsAll_ && count == 2 && isConstant(operands[1]))
    return avoidUndefined(code, base, operands[0], operands[1]);
  return intern({code, base}, {operands.data(), count});
}

Id Recorder::avoidUndefined(Code code, Base base, Id x, Id y) {
  switch (code) {
    case Code::IntDiv:
    case Code::UintDiv:
      if (value(y) == 0) return x;
      break;
    case Code::IntMod:
    case Code::UintMod:
      if (value(y) == 0) return constant(base, 0);
      break;
    case Code::ShiftLeft:
    case Code::ShiftRight:
    case Code::UintShiftRight:
      y = constant(Base::Int, static_cast<double>(static_cast<std::int64_t>(value(y)) & 31));
      break;
    default:
      break;
  }
  return intern({code, base}, std::array{x, y});
}

Id Recorder::logicalNot(Id condition) {
  if (isUndefined(condition)) return condition;
  if (isConstant(condition)) return constant(Base::Bool, value(condition) == 0);
  if (at(condition).code == Code::Not) return operands(condition)[0];
  return apply(Code::Not, Base::Bool, {condition});
}

Id Recorder::logicalAnd(Id a, Id b) {
  if (isTrue(a) || a == b) return b;
  if (isTrue(b) || isFalse(a)) return a;
  if (isFalse(b)) return b;
  return apply(Code::And, Base::Bool, {a, b});
}

Id Recorder::logicalOr(Id a, Id b) {
  if (isFalse(a) || a == b) return b;
  if (isFalse(b) || isTrue(a)) return a;
  if (isTrue(b)) return b;
  return apply(Code::Or, Base::Bool, {a, b});
}

Id Recorder::choose(Id condition, Id yes, Id no) {
  if (isUndefined(yes) || yes == no) return no;
  if (isUndefined(no)) return yes;
  if (isConstant(condition)) return isTrue(condition) ? yes : no;
  const auto isChoice = [&](Id id) {
    return at(id).code == Code::IfElse && operands(id)[0] == condition;
  };
  if (isChoice(yes)) return choose(condition, operands(yes)[1], no);
  if (isChoice(no)) return choose(condition, yes, operands(no)[2]);
  if (at(condition).code == Code::Not) return choose(operands(condition)[0], no, yes);
  switch (base(yes)) {
    case Base::Bool:
      if (isTrue(yes)) return logicalOr(condition, no);
      if (isFalse(no)) return logicalAnd(condition, yes);
      if (no == condition) return logicalAnd(condition, yes);
      if (yes == condition) return logicalOr(condition, no);
      return logicalOr(logicalAnd(condition, yes), logicalAnd(logicalNot(condition), no));
    case Base::Float:
      return apply(Code::IfElse, Base::Float, {condition, yes, no});
    default:
      return apply(Code::IntIfElse, base(yes), {condition, yes, no});
  }
}

Id Recorder::convert(Id value, Base to) {
  using enum Base;
  const Base from = base(value);
  if (from == to) return value;
  if (isUndefined(value)) return undefined(to);
  if (isConstant(value)) {
    const double known = this->value(value);
    if (to == Bool || to == Float || from == Bool) return constant(to, known);
    if (from != Float || std::abs(known) < 4294967296.0) return constant(to, std::trunc(known));
  }
  if (from == Bool) {
    const Id one = constant(to, 1), zero = constant(to, 0);
    return choose(value, one, zero);
  }
  if (to == Bool) {
    const Id zero = constant(from, 0);
    if (from == Float) return apply(Code::Ne, Bool, {value, zero});
    return logicalNot(apply(Code::IntEq, Bool, {value, zero}));
  }
  if (to == Float && at(value).code == Code::IntOf && isIntegral(operands(value)[0]))
    return operands(value)[0];
  if (to == Float) return apply(from == Int ? Code::FloatOf : Code::FloatOfUint, Float, {value});
  if (from == Float) return apply(to == Int ? Code::IntOf : Code::UintOf, to, {value});
  // The bits are equal for int and uint.
  return apply(Code::SameBits, to, {value});
}

}  // namespace warpjet::source
