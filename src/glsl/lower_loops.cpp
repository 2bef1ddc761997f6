// Loops: what stays one in the shader, and what is written as often as it runs.
#include <algorithm>

#include "glsl/loops.hpp"
#include "glsl/lower.hpp"

namespace warpjet::glsl {

namespace {

// Of a loop whose end is known.
constexpr int mostIterations = 20'000;
// What the builder takes: of loops within each other all multiplied, and so deep.
constexpr std::uint32_t mostFoldedSteps = 10'000;
constexpr std::size_t deepestFolds = 8;
// Of an array that a loop fills, every element is a state.
constexpr std::size_t mostStates = 32;
// The limit for a loop that only the shader ends, without the option maxIterations.
constexpr int mostUnknown = 1'000;
constexpr const char* endsUnknown =
    "how often this loop runs depends on what only the shader knows; count to a constant and "
    "break, or give the option maxIterations";
// Whole numbers that float32 counts without a gap, and then some.
constexpr double large = 1 << 22;

bool isSmall(double x) { return x == std::trunc(x) && std::abs(x) <= large; }

}  // namespace

void Lowering::loop(const Statement& statement) {
  execute(statement.children[0]);
  const Id no = number(Base::Bool, 0);
  const Slot broken = store_.allocate(1, no), continued = store_.allocate(1, no);
  breakables_.push_back({broken, continued, false});
  if (!foldLoop(statement)) unroll(statement);
  breakables_.pop_back();
}

// Condition, body and step once, where nothing was stopped; the condition of a `do` comes last.
// Gives the condition, which is taken to hold unless the loop asks for it. `end` is called where
// the next iteration would begin.
template <class End>
Id Lowering::iterate(const Statement& statement, bool asks, const End& end) {
  const Breakable here = breakables_.back();
  Id test = number(Base::Bool, 1);
  // What comes next where the condition holds, if the loop asks for it.
  const auto check = [&](const auto& next) {
    if (statement.expression != nothing) test = condition(statement.expression);
    if (!asks) return next();
    branch(test, next, [&] { store_.set(here.broken, number(Base::Bool, 1)); });
  };
  const auto run = [&] {
    execute(statement.children[2]);
    store_.set(here.continued, number(Base::Bool, 0));
    branch(
        stopped(), [] {},
        [&] {
          resume();
          execute(statement.children[1]);
          if (statement.isLate) return check(end);
          end();
        });
  };
  branch(
      stopped(), [] {},
      [&] {
        resume();
        if (statement.isLate) return run();
        check(run);
      });
  return test;
}

// What the first iteration changes, and how, as far as one tells.
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

// What a variable is in the step of a loop.
Id Lowering::duringLoop(const Changing& each, std::uint32_t loop, std::size_t place) {
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
  return fromState(recorder_.state(loop, place), base);
}

// A condition is a state of 0 or 1.
Id Lowering::fromState(Id state, Base base) {
  if (base == Base::Bool)
    return recorder_.apply(Code::Gt, Base::Bool, {state, number(Base::Float, 0.5)});
  return recorder_.convert(state, base);
}

// Whether an int only counts, and so can be a float: from what it was, or a constant, by constants.
bool Lowering::counts(Id next, Id before, std::uint32_t steps, int depth) const {
  if (next == before) return true;
  if (depth == 0) return false;
  const auto isOf = [&](Id id, double most) {
    return recorder_.isConstant(id) && std::abs(recorder_.value(id)) <= most;
  };
  if (isOf(next, large)) return true;
  const auto operands = recorder_.operands(next);
  switch (recorder_.at(next).code) {
    case Code::IntIfElse:
      return counts(operands[1], before, steps, depth - 1) &&
             counts(operands[2], before, steps, depth - 1);
    case Code::IntAdd:
    case Code::IntSub:
      return isOf(operands[1], large / (8.0 * steps)) &&
             counts(operands[0], before, steps, depth - 1);
    default:
      return false;
  }
}

// A loop of the shader, if it can be one and should. Its body is recorded once, between the
// variables that it changes: counters follow from the number of the step, what else it changes is a
// state. States are floats, which lose the bits of an int or uint that does more than to count:
// such a loop is unrolled.
bool Lowering::foldLoop(const Statement& statement) {
  if (problems_.any() || openLoops_.size() >= deepestFolds) return false;
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
    // So that thousands of long loops end too, in a loop that is unrolled.
    steps_ += *steps / 64;
  } else {
    if (maxIterations_ == 0) return false;
    folding.asks = true;
    folding.steps = static_cast<std::uint32_t>(maxIterations_);
    if (!record(statement, folding)) return giveUp();
  }
  if (!isWorthIt(folding, once) ||
      1.0 * folding.steps * recorder_.loop(folding.loop).inner > mostFoldedSteps)
    return false;
  return close(statement, folding);
}

// Until what was taken for the same in every iteration, or for a counter, is.
bool Lowering::record(const Statement& statement, Folding& folding) {
  std::vector<Changing>& all = folding.all;
  for (int attempt = 0; attempt < 8; ++attempt) {
    if (all.size() > mostStates || recorder_.loopCount() >= Recorder::mostLoops) return false;
    const std::uint32_t loop = recorder_.openLoop(openLoops_.empty() ? 0 : openLoops_.back());
    const std::size_t size = recorder_.size();
    folding.loop = loop;
    openLoops_.push_back(loop);
    store_.open();
    for (std::size_t i = 0; i < all.size(); ++i)
      store_.set(all[i].slot, all[i].now = duringLoop(all[i], loop, i));
    bool hasEnd = false;
    folding.test = iterate(statement, folding.asks, [&] {
      hasEnd = true;
      for (Changing& each : all) each.atEnd = store_.get(each.slot);
    });
    for (Changing& each : all) each.next = store_.get(each.slot);
    openLoops_.pop_back();
    const Store::Changes changes = store_.close();
    if (problems_.any() || !hasEnd) return false;
    folding.size = recorder_.size() - size;
    if (isRight(statement, folding, changes)) return true;
  }
  return false;
}

bool Lowering::isRight(const Statement& statement, Folding& folding,
                       const Store::Changes& changes) {
  using enum Changing::Kind;
  bool isRight = true;
  for (Changing& each : folding.all) {
    const auto isNext = [&](Operator op, double by) {
      const Base base = recorder_.base(each.now);
      return each.atEnd == scalar(op, base, each.now, number(base, by));
    };
    // After an early end it is none of what would follow from the number of steps.
    const bool isKnownAfter = each.next == each.atEnd || declares(statement, each.slot);
    if (each.kind == Fixed && each.next != each.start) {
      each.kind = State;
      isRight = false;
    } else if (each.kind == Counter && !(isKnownAfter && (isNext(Operator::Add, each.by) ||
                                                          isNext(Operator::Subtract, -each.by)))) {
      each.kind = State;
      isRight = false;
    }
  }
  for (const auto& [slot, value] : changes) {
    const auto isThis = [&, at = slot](const Changing& each) { return each.slot == at; };
    if (std::any_of(folding.all.begin(), folding.all.end(), isThis)) continue;
    folding.all.push_back({slot, store_.get(slot)});
    isRight = false;
  }
  return isRight;
}

// Whether a variable is the loop's own, and gone after it.
bool Lowering::declares(const Statement& loop, Slot slot) const {
  if (loop.children[0] == nothing) return false;
  for (const Statement* each : declarationsOf(loop.children[0])) {
    const Slot first = slotOf(each->index);
    const auto size = static_cast<Slot>(sizeOf(tree_.variables[each->index].type));
    if (slot >= first && slot - first < size) return true;
  }
  return false;
}

// How often the condition holds, if only numbers decide that are known. These are followed as they
// are in the shader, in float32.
std::optional<std::uint32_t> Lowering::stepsOf(const Statement& statement,
                                               const Folding& folding) const {
  LoopRun run(recorder_, folding.loop, folding.all);
  for (std::uint32_t step = 0; step <= mostFoldedSteps; ++step) {
    const auto test = run.value(folding.test);
    if (!test) return std::nullopt;
    if (*test == 0) return step + statement.isLate;
    run.advance();
  }
  return std::nullopt;
}

bool Lowering::isWorthIt(const Folding& folding, std::size_t once) const {
  return folding.steps > 2 && folding.steps * once > folding.size + worthwhile;
}

bool Lowering::close(const Statement& statement, const Folding& folding) {
  std::vector<Id> starts, nexts;
  std::vector<const Changing*> states;
  const auto held = [&](Id id) {
    return recorder_.isUndefined(id) ? number(Base::Float, 0) : recorder_.convert(id, Base::Float);
  };
  for (std::size_t i = 0; i < folding.all.size(); ++i) {
    const Changing& each = folding.all[i];
    const Base base = recorder_.base(each.start);
    const bool isState = each.kind == Changing::Kind::State;
    const bool isStart = recorder_.isUndefined(each.start) ||
                         (recorder_.isConstant(each.start) && isSmall(recorder_.value(each.start)));
    if (isState && base == Base::Int &&
        !(isStart && counts(each.next, each.now, folding.steps, 16)))
      return false;
    if (isState && (base == Base::Uint || base == Base::Sampler)) return false;
    // The place of a state is that of its variable; what is none stays 0.
    starts.push_back(isState ? held(each.start) : number(Base::Float, 0));
    nexts.push_back(isState ? held(each.next) : number(Base::Float, 0));
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
  // The condition that ends it may change something, as `i-- > 0` does.
  if (!folding.asks && !statement.isLate)
    branch(
        stopped(), [] {},
        [&] {
          resume();
          condition(statement.expression);
        });
  return true;
}

// Whether nothing but a break or a return can end it.
bool Lowering::hasNoEnd(const Statement& statement) const {
  if (statement.expression == nothing) return true;
  const Expression& test = tree_.expressions[statement.expression];
  return test.kind == Expression::Kind::Constant && test.value != 0;
}

// Where it is not known whether there is another iteration, that and all after it are in a branch
// of their own; so counters stay known. The branches close in the end, the last first.
void Lowering::unroll(const Statement& statement) {
  const Id no = number(Base::Bool, 0);
  std::vector<Id> conditions;
  const auto enter = [&](Id condition) {
    conditions.push_back(condition);
    store_.open();
  };
  const Problems before = problems_;
  // The iterations that only the shader can end. The first one of a `do` is one of them.
  int unknown = statement.isLate;
  const bool isEndless = hasNoEnd(statement);
  for (int iteration = 0; !isTooMuch(statement.place); ++iteration) {
    if (iteration > mostIterations) {
      problems_.add(statement.place, "this loop has not ended after " +
                                         std::to_string(mostIterations) + " iterations");
      break;
    }
    if (statement.expression != nothing && (iteration > 0 || !statement.isLate)) {
      const Id test = condition(statement.expression);
      if (recorder_.isFalse(test) || recorder_.isUndefined(test)) break;
      if (!recorder_.isConstant(test)) {
        if (maxIterations_ == 0) {
          problems_.add(statement.place, endsUnknown);
          break;
        }
        if (unknown++ == maxIterations_) break;
        enter(test);
      }
    }
    execute(statement.children[2]);
    store_.set(breakables_.back().continued, no);
    const Id isOver = stopped();
    if (recorder_.isTrue(isOver)) break;
    if (!recorder_.isConstant(isOver)) {
      if (isEndless && maxIterations_ > 0 && iteration + 1 >= maxIterations_) break;
      if (isEndless && maxIterations_ == 0 && ++unknown > mostUnknown)
        problems_.add(statement.place, endsUnknown);
      enter(recorder_.negated(isOver));
      resume();
    }
    execute(statement.children[1]);
  }
  // What ran so long that it became too much.
  if (problems_.any() && !before.any() && isEndless && unknown > 1 && maxIterations_ == 0) {
    problems_ = before;
    problems_.add(statement.place, endsUnknown);
  }
  for (std::size_t i = conditions.size(); i-- > 0;) merge(conditions[i], store_.close(), {});
}

}  // namespace warpjet::glsl
