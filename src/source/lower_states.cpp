// The variables that a loop of the shader changes: whether they are computed from the step number
// or are states, and how states represent them.
#include <algorithm>
#include <cmath>

#include "source/lower.hpp"

namespace warpjet::source {

namespace {

// Float32 represents all integers up to `maxExact`. Counters start at, or are reset to, at most
// `large`.
constexpr double maxExact = 1 << 24, large = 1 << 22;
// The number of values of a half of 16 bits.
constexpr double halfSize = 1 << 16;
// Limits recursion in the expression of a counter.
constexpr int maxCountDepth = 16;

bool isSmall(double x) { return x == std::trunc(x) && std::abs(x) <= large; }

bool isInteger(Base base) { return base == Base::Int || base == Base::Uint; }

// Returns true if float32 computes the counter from the step number exactly.
bool isExact(const Changing& counter, double start, const Folding& folding) {
  return std::abs(start) + std::abs(counter.by) * folding.steps <= maxExact;
}

}  // namespace

// Returns the value that a variable has if the loop goes on: a break leaves it as it was.
Id Lowering::valueIfContinued(Id value, Id start) const {
  while (recorder_.at(value).code == Code::IfElse || recorder_.at(value).code == Code::IntIfElse) {
    const auto operands = recorder_.operands(value);
    if (operands[1] != start && operands[2] != start) break;
    value = operands[1] == start ? operands[2] : operands[1];
  }
  return value;
}

// Guesses from the first iteration how variables change.
std::vector<Changing> Lowering::changesOf(const Store::Changes& changes) const {
  std::vector<Changing> all;
  for (const auto& [slot, changed] : changes) {
    const Id start = store_.get(slot), value = valueIfContinued(changed, start);
    Changing each{slot, start};
    const bool areKnown = recorder_.isConstant(start) && recorder_.isConstant(value);
    if (value == start) {
      each.kind = Changing::Kind::Fixed;
    } else if (areKnown && recorder_.base(start) != Base::Bool && isSmall(recorder_.value(start)) &&
               isSmall(recorder_.value(value))) {
      each.kind = Changing::Kind::Counter;
      each.by = recorder_.value(value) - recorder_.value(start);
    }
    all.push_back(each);
  }
  return all;
}

// Returns true if the value of a counter can be computed from the step number. Integers wrap around
// as in the source; floats would round differently.
bool Lowering::isRepresentable(const Changing& counter, const Folding& folding) const {
  return isInteger(recorder_.base(counter.start)) ||
         isExact(counter, recorder_.value(counter.start), folding);
}

// Returns the value of a variable in a step of the loop.
Id Lowering::valueInStep(const Changing& each, const Folding& folding, std::size_t location) {
  const std::uint32_t loop = folding.loop;
  if (each.kind == Changing::Kind::Fixed) return each.start;
  if (each.kind == Changing::Kind::State)
    return fromState(each, recorder_.state(loop, location),
                     [&](std::size_t high) { return recorder_.state(loop, high); });
  const Base base = recorder_.base(each.start);
  const double start = recorder_.value(each.start);
  const bool isFloat = isExact(each, start, folding) && (base != Base::Uint || each.by > 0);
  const Base computed = isFloat ? Base::Float : base;
  Id at = recorder_.convert(recorder_.step(loop), computed);
  if (each.by != 1) at = scalar(Operator::Multiply, computed, at, number(computed, each.by));
  if (start != 0) at = scalar(Operator::Add, computed, at, number(computed, start));
  return recorder_.convert(at, base);
}

// Converts a state to the type of its variable. A condition is stored as 0 or 1. `at` returns the
// state at an index.
template <class At>
Id Lowering::fromState(const Changing& each, Id state, const At& at) {
  const Base base = recorder_.base(each.start);
  if (base == Base::Bool)
    return recorder_.apply(Code::Gt, Base::Bool, {state, number(Base::Float, 0.5)});
  const Id low = recorder_.convert(state, base);
  if (!each.isWide) return low;
  // Multiplies instead of shifting, since GLSL 1.00 has no bitwise operators.
  const Id high = scalar(Operator::Multiply, base, recorder_.convert(at(each.high), base),
                         number(base, halfSize));
  return scalar(Operator::Add, base, high, low);
}

// Returns the states that represent a value: one, or a lower and an upper half.
Lowering::Value Lowering::toStates(const Changing& each, Id value) {
  if (recorder_.isUndefined(value)) value = number(recorder_.base(each.start), 0);
  if (!each.isWide) return {recorder_.convert(value, Base::Float)};
  const Base base = recorder_.base(value);
  const Id size = number(base, halfSize), high = scalar(Operator::Divide, base, value, size);
  const Id low =
      scalar(Operator::Subtract, base, value, scalar(Operator::Multiply, base, high, size));
  return {recorder_.convert(low, Base::Float), recorder_.convert(high, Base::Float)};
}

// Returns a bound of the change per step of an int or uint that only counts: its next value is a
// small constant, or its previous value plus constants. Returns nullopt if it does more than that.
std::optional<double> Lowering::changePerStep(Id next, Id before, int depth) const {
  if (next == before) return 0;
  if (depth == 0) return std::nullopt;
  const auto isSmallConstant = [&](Id id) {
    return recorder_.isConstant(id) && isSmall(recorder_.value(id));
  };
  if (isSmallConstant(next)) return 0;
  const auto operands = recorder_.operands(next);
  const Code code = recorder_.at(next).code;
  if (code == Code::IntIfElse) {
    const auto yes = changePerStep(operands[1], before, depth - 1);
    const auto no = yes ? changePerStep(operands[2], before, depth - 1) : std::nullopt;
    return no ? std::optional(std::max(*yes, *no)) : std::nullopt;
  }
  // A uint that counts down may pass 0.
  const bool isSum =
      code == Code::IntAdd || (code == Code::IntSub && recorder_.base(next) == Base::Int);
  if (!isSum || !isSmallConstant(operands[1])) return std::nullopt;
  const auto rest = changePerStep(operands[0], before, depth - 1);
  return rest ? std::optional(*rest + std::abs(recorder_.value(operands[1]))) : std::nullopt;
}

// Returns true if an int or uint does not exceed the integers that a float represents.
bool Lowering::onlyCounts(const Changing& each, const Folding& folding) const {
  const bool startsSmall =
      recorder_.isUndefined(each.start) ||
      (recorder_.isConstant(each.start) && isSmall(recorder_.value(each.start)));
  const auto change = changePerStep(each.next, each.now, maxCountDepth);
  return startsSmall && change && large + *change * folding.steps <= maxExact;
}

// Gives two states to ints and uints that do more than count. Returns true if there are new ones,
// so that the body must be recorded again.
bool Lowering::widenStates(Folding& folding) const {
  bool hasNew = false;
  for (Changing& each : folding.all) {
    if (each.kind != Changing::Kind::State || each.isWide) continue;
    if (!isInteger(recorder_.base(each.start)) || onlyCounts(each, folding)) continue;
    each.isWide = hasNew = true;
  }
  return hasNew;
}

// Adds the operation of a recorded loop, and sets the variables to their values after it.
bool Lowering::close(const Statement& statement, const Folding& folding) {
  // The state of each variable has the index of the variable in `folding.all`. Variables that are
  // not states get a state that stays 0.
  std::vector<Id> starts(folding.all.size(), number(Base::Float, 0)), nexts = starts;
  for (std::size_t i = 0; i < folding.all.size(); ++i) {
    const Changing& each = folding.all[i];
    if (each.kind != Changing::Kind::State) continue;
    if (recorder_.base(each.start) == Base::Sampler) return false;
    const Value start = toStates(each, each.start), next = toStates(each, each.next);
    starts[i] = start[0];
    nexts[i] = next[0];
    starts.insert(starts.end(), start.begin() + 1, start.end());
    nexts.insert(nexts.end(), next.begin() + 1, next.end());
  }
  if (starts.empty()) return false;
  const Id fold = recorder_.fold(folding.loop, folding.steps, starts, nexts);
  const auto outcome = [&](std::size_t i) { return recorder_.outcome(fold, i); };
  for (std::size_t i = 0; i < folding.all.size(); ++i) {
    const Changing& each = folding.all[i];
    if (each.kind == Changing::Kind::State) {
      store_.set(each.slot, fromState(each, outcome(i), outcome));
    } else if (each.kind == Changing::Kind::Counter) {
      const Base base = recorder_.base(each.start);
      const double end = recorder_.value(each.start) + each.by * folding.steps;
      store_.set(each.slot,
                 declares(statement, each.slot) ? recorder_.undefined(base) : number(base, end));
    }
  }
  // The condition that ends the loop may have side effects, as in `i-- > 0`.
  if (!folding.evaluatesTest && !statement.testsAfterBody)
    unlessStopped(store_.now(), [&] { condition(statement.expression); });
  return true;
}

}  // namespace warpjet::source
