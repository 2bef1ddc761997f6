// Folds: loops of the source that remain loops in the shader.
#include <algorithm>
#include <cmath>

#include "source/loops.hpp"
#include "source/lower.hpp"

namespace warpjet::source {

namespace {

// The limits of the builder: the product of the iterations of nested loops, and their depth.
constexpr std::uint32_t maxFoldedSteps = 10'000;
constexpr std::size_t maxFoldDepth = 8;
// Every element of an array that a loop fills is a state.
constexpr std::size_t maxStates = 32;
// Integers that float32 counts exactly, with a margin.
constexpr double large = 1 << 22;

bool isSmall(double x) { return x == std::trunc(x) && std::abs(x) <= large; }

}  // namespace

// Runs condition, body and step once, in branches that end at a break, continue or return; the
// condition of a `do` comes last. Returns the condition, which is assumed to hold unless
// `evaluatesTest` is set. Calls `end` where the next iteration would start.
template <class End>
Id Lowering::iterate(const Statement& statement, bool evaluatesTest, const End& end) {
  const Breakable here = breakables_.back();
  Id test = number(Base::Bool, 1);
  // Runs `next` if the condition holds, in case the loop evaluates it.
  const auto check = [&](const auto& next) {
    if (statement.expression != nothing) test = condition(statement.expression);
    if (!evaluatesTest) return next();
    branch(test, next, [&] { store_.set(here.broken, number(Base::Bool, 1)); });
  };
  const auto run = [&] {
    execute(statement.children[2]);
    store_.set(here.continued, number(Base::Bool, 0));
    branch(
        stopCondition(), [] {},
        [&] {
          resume();
          execute(statement.children[1]);
          if (statement.isLate) return check(end);
          end();
        });
  };
  branch(
      stopCondition(), [] {},
      [&] {
        resume();
        if (statement.isLate) return run();
        check(run);
      });
  return test;
}

// Guesses from the first iteration how variables change.
std::vector<Changing> Lowering::changesOf(const Store::Changes& changes) const {
  std::vector<Changing> all;
  for (const auto& [slot, value] : changes) {
    const Id start = store_.get(slot);
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

// Returns the value of a variable in a step of the loop.
Id Lowering::valueInStep(const Changing& each, std::uint32_t loop, std::size_t location) {
  const Base base = recorder_.base(each.start);
  const auto apply = [&](Code code, Id x, double y) {
    return recorder_.apply(code, Base::Float, {x, number(Base::Float, y)});
  };
  if (each.kind == Changing::Kind::Fixed) return each.start;
  if (each.kind == Changing::Kind::Counter) {
    Id at = recorder_.step(loop);
    const double start = recorder_.value(each.start);
    if (each.by != 1) at = apply(Code::Mult, at, each.by);
    if (start != 0) at = apply(Code::Add, at, start);
    return recorder_.convert(at, base);
  }
  return fromState(recorder_.state(loop, location), base);
}

// Converts a state to the type of its variable. A condition is stored as 0 or 1.
Id Lowering::fromState(Id state, Base base) {
  if (base == Base::Bool)
    return recorder_.apply(Code::Gt, Base::Bool, {state, number(Base::Float, 0.5)});
  return recorder_.convert(state, base);
}

// Returns true if an int only counts, so that a float can represent it: its next value is a
// constant, or its previous value plus constants.
bool Lowering::onlyCounts(Id next, Id before, std::uint32_t steps, int depth) const {
  if (next == before) return true;
  if (depth == 0) return false;
  const auto isWithin = [&](Id id, double max) {
    return recorder_.isConstant(id) && std::abs(recorder_.value(id)) <= max;
  };
  if (isWithin(next, large)) return true;
  const auto operands = recorder_.operands(next);
  switch (recorder_.at(next).code) {
    case Code::IntIfElse:
      return onlyCounts(operands[1], before, steps, depth - 1) &&
             onlyCounts(operands[2], before, steps, depth - 1);
    case Code::IntAdd:
    case Code::IntSub:
      return isWithin(operands[1], large / (8.0 * steps)) &&
             onlyCounts(operands[0], before, steps, depth - 1);
    default:
      return false;
  }
}

// Makes a loop of the shader if that is possible and worthwhile. The body is recorded once, in
// terms of the variables that it changes: counters are computed from the step number, other
// variables are states. States are floats, which can't represent all bits of an int or uint that
// does more than count: such a loop is unrolled.
bool Lowering::foldLoop(const Statement& statement) {
  if (problems_.any() || openLoops_.size() >= maxFoldDepth) return false;
  const Problems before = problems_;
  const std::size_t size = recorder_.size();
  store_.open();
  const Id first = iterate(statement, false, [] {});
  const Store::Changes changes = store_.close();
  const std::size_t once = recorder_.size() - size;
  const auto giveUp = [&] {
    problems_ = before;
    return false;
  };
  if (problems_.any() || recorder_.isFalse(first)) return giveUp();

  Folding folding{changesOf(changes), 0, first, false, 0, 0};
  if (!record(statement, folding)) return giveUp();
  const auto steps = stepsOf(statement, folding);
  if (steps) {
    folding.steps = *steps;
    // Long loops count as several steps, so that thousands of them in an unrolled loop are limited,
    // too.
    steps_ += *steps / 64;
  } else {
    if (maxIterations_ == 0) return false;
    folding.evaluatesTest = true;
    folding.steps = static_cast<std::uint32_t>(maxIterations_);
    if (!record(statement, folding)) return giveUp();
  }
  if (!isWorthIt(folding, once) ||
      1.0 * folding.steps * recorder_.loop(folding.loop).inner > maxFoldedSteps)
    return false;
  return close(statement, folding);
}

// Records the body, and repeats that until the guesses about constant variables and counters hold.
bool Lowering::record(const Statement& statement, Folding& folding) {
  std::vector<Changing>& all = folding.all;
  for (int attempt = 0; attempt < 8; ++attempt) {
    if (all.size() > maxStates || recorder_.loopCount() >= Recorder::maxLoops) return false;
    const std::uint32_t loop = recorder_.openLoop(openLoops_.empty() ? 0 : openLoops_.back());
    const std::size_t size = recorder_.size();
    folding.loop = loop;
    openLoops_.push_back(loop);
    store_.open();
    for (std::size_t i = 0; i < all.size(); ++i)
      store_.set(all[i].slot, all[i].now = valueInStep(all[i], loop, i));
    bool hasEnd = false;
    folding.test = iterate(statement, folding.evaluatesTest, [&] {
      hasEnd = true;
      for (Changing& each : all) each.atEnd = store_.get(each.slot);
    });
    for (Changing& each : all) each.next = store_.get(each.slot);
    openLoops_.pop_back();
    const Store::Changes changes = store_.close();
    if (problems_.any() || !hasEnd) return false;
    folding.size = recorder_.size() - size;
    if (confirmGuesses(statement, folding, changes)) return true;
  }
  return false;
}

bool Lowering::confirmGuesses(const Statement& statement, Folding& folding,
                              const Store::Changes& changes) {
  using enum Changing::Kind;
  bool areRight = true;
  for (Changing& each : folding.all) {
    const auto isNext = [&](Operator op, double step) {
      const Base base = recorder_.base(each.now);
      return each.atEnd == scalar(op, base, each.now, number(base, step));
    };
    // After an early end, the value doesn't follow from the number of steps.
    const bool isKnownAfter = each.next == each.atEnd || declares(statement, each.slot);
    if (each.kind == Fixed && each.next != each.start) {
      each.kind = State;
      areRight = false;
    } else if (each.kind == Counter && !(isKnownAfter && (isNext(Operator::Add, each.by) ||
                                                          isNext(Operator::Subtract, -each.by)))) {
      each.kind = State;
      areRight = false;
    }
  }
  for (const auto& [slot, value] : changes) {
    const auto hasSlot = [&, wanted = slot](const Changing& each) { return each.slot == wanted; };
    if (std::any_of(folding.all.begin(), folding.all.end(), hasSlot)) continue;
    folding.all.push_back({slot, store_.get(slot)});
    areRight = false;
  }
  return areRight;
}

// Returns true if a variable belongs to the loop and doesn't exist after it.
bool Lowering::declares(const Statement& loop, Slot slot) const {
  if (loop.children[0] == nothing) return false;
  for (const Statement* each : declarationsOf(loop.children[0])) {
    const Slot first = slotOf(each->index);
    const auto size = static_cast<Slot>(sizeOf(tree_.variables[each->index].type));
    if (slot >= first && slot - first < size) return true;
  }
  return false;
}

// Returns the number of iterations, if it depends only on known numbers. They are computed in
// float32, as in the shader.
std::optional<std::uint32_t> Lowering::stepsOf(const Statement& statement,
                                               const Folding& folding) const {
  LoopRun run(recorder_, folding.loop, folding.all);
  for (std::uint32_t step = 0; step <= maxFoldedSteps; ++step) {
    const auto test = run.value(folding.test);
    if (!test) return std::nullopt;
    if (*test == 0) return step + statement.isLate;
    run.advance();
  }
  return std::nullopt;
}

bool Lowering::isWorthIt(const Folding& folding, std::size_t once) const {
  return folding.steps > 2 && folding.steps * once > folding.size + minSavedOperations;
}

bool Lowering::close(const Statement& statement, const Folding& folding) {
  std::vector<Id> starts, nexts;
  std::vector<const Changing*> states;
  const auto asFloat = [&](Id id) {
    return recorder_.isUndefined(id) ? number(Base::Float, 0) : recorder_.convert(id, Base::Float);
  };
  for (std::size_t i = 0; i < folding.all.size(); ++i) {
    const Changing& each = folding.all[i];
    const Base base = recorder_.base(each.start);
    const bool isState = each.kind == Changing::Kind::State;
    const bool isStart = recorder_.isUndefined(each.start) ||
                         (recorder_.isConstant(each.start) && isSmall(recorder_.value(each.start)));
    if (isState && base == Base::Int &&
        !(isStart && onlyCounts(each.next, each.now, folding.steps, 16)))
      return false;
    if (isState && (base == Base::Uint || base == Base::Sampler)) return false;
    // The state of each variable has the index of the variable in `folding.all`. Variables that are
    // not states get a state that stays 0.
    starts.push_back(isState ? asFloat(each.start) : number(Base::Float, 0));
    nexts.push_back(isState ? asFloat(each.next) : number(Base::Float, 0));
  }
  if (starts.empty()) return false;
  const Id fold = recorder_.fold(folding.loop, folding.steps, starts, nexts);
  for (std::size_t i = 0; i < folding.all.size(); ++i) {
    const Changing& each = folding.all[i];
    const Base base = recorder_.base(each.start);
    if (each.kind == Changing::Kind::State) {
      store_.set(each.slot, fromState(recorder_.outcome(fold, i), base));
    } else if (each.kind == Changing::Kind::Counter) {
      const double end = recorder_.value(each.start) + each.by * folding.steps;
      store_.set(each.slot,
                 declares(statement, each.slot) ? recorder_.undefined(base) : number(base, end));
    }
  }
  // The condition that ends the loop may have side effects, as in `i-- > 0`.
  if (!folding.evaluatesTest && !statement.isLate)
    branch(
        stopCondition(), [] {},
        [&] {
          resume();
          condition(statement.expression);
        });
  return true;
}

}  // namespace warpjet::source
