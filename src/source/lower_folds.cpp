// Folds: loops of the source that remain loops in the shader.
#include <algorithm>

#include "source/loops.hpp"
#include "source/lower.hpp"

namespace warpjet::source {

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
    const std::size_t before = store_.now();
    execute(statement.children[2]);
    store_.set(here.continued, number(Base::Bool, 0));
    unlessStopped(before, [&] {
      execute(statement.children[1]);
      if (statement.testsAfterBody) return check(end);
      end();
    });
  };
  unlessStopped(store_.now(), [&] {
    if (statement.testsAfterBody) return run();
    check(run);
  });
  return test;
}

// Makes a loop of the shader if that is possible and worthwhile. The body is recorded once, in
// terms of the variables that it changes: counters are computed from the step number, other
// variables are states.
bool Lowering::foldLoop(const Statement& statement) {
  if (problems_.any() || openLoops_.size() >= maxFoldDepth) return false;
  const Problems before = problems_, cutOffBefore = cutOff_;
  const std::size_t size = recorder_.size();
  store_.open();
  const Id first = iterate(statement, false, [] {});
  const Store::Changes changes = store_.close();
  const std::size_t once = recorder_.size() - size;
  const std::size_t unknownLoops = unknownLoops_, unknownFolds = unknownFolds_;
  const auto giveUp = [&] {
    unknownLoops_ = unknownLoops;
    unknownFolds_ = unknownFolds;
    problems_.restore(before);
    cutOff_ = cutOffBefore;
    return false;
  };
  if (problems_.any() || recorder_.isFalse(first)) return giveUp();

  Folding folding{changesOf(changes), maxFoldedSteps, first, false, 0, 0};
  if (!record(statement, folding)) return giveUp();
  if (const auto steps = stepsOf(statement, folding)) {
    folding.steps = *steps;
    // Long loops count as several steps, so that thousands of them in an unrolled loop are limited,
    // too.
    steps_ += *steps / 64;
  } else {
    if (maxIterations_ == rejectUnknown) return giveUp();
    evaluateTest(folding);
    if (!enterUnknown().empty()) return giveUp();
    if (hasNoEnd(statement)) ++unknownFolds_;
    if (!record(statement, folding)) return giveUp();
  }
  while (widenStates(folding))
    if (!record(statement, folding)) return giveUp();
  const std::uint32_t inner = recorder_.loop(folding.loop).inner;
  const bool isShort = !folding.isCounted() || 1.0 * folding.steps * inner <= maxFoldedSteps;
  if (!isShort || !isWorthIt(folding, once) || !close(statement, folding)) return giveUp();
  unknownLoops_ = unknownLoops;
  unknownFolds_ = unknownFolds;
  return true;
}

// Makes the loop evaluate its condition in each step. Whether it has ended becomes its first state.
void Lowering::evaluateTest(Folding& folding) {
  folding.evaluatesTest = true;
  folding.steps =
      maxIterations_ == untilEnd ? uncountedSteps : static_cast<std::uint32_t>(maxIterations_);
  const Slot broken = breakables_.back().broken;
  std::erase_if(folding.all, [&](const Changing& each) { return each.slot == broken; });
  folding.all.insert(folding.all.begin(), {broken, number(Base::Bool, 0)});
}

// Records the body, and repeats that until the guesses about constant variables and counters hold.
bool Lowering::record(const Statement& statement, Folding& folding) {
  std::vector<Changing>& all = folding.all;
  for (int attempt = 0; attempt < 8; ++attempt) {
    std::size_t states = all.size();
    for (Changing& each : all)
      if (each.isWide) each.high = states++;
    if (states > maxStates || recorder_.loopCount() >= Recorder::maxLoops) return false;
    const std::uint32_t loop = recorder_.openLoop(openLoops_.empty() ? 0 : openLoops_.back());
    const std::size_t size = recorder_.size();
    folding.loop = loop;
    openLoops_.push_back(loop);
    store_.open();
    for (std::size_t i = 0; i < all.size(); ++i)
      store_.set(all[i].slot, all[i].now = valueInStep(all[i], folding, i));
    bool hasEnd = false;
    folding.test = iterate(statement, folding.evaluatesTest, [&] {
      hasEnd = true;
      for (Changing& each : all) each.atEnd = store_.get(each.slot);
    });
    // A return ends the loop, too.
    if (folding.evaluatesTest) store_.set(breakables_.back().broken, stopCondition());
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
    } else if (each.kind == Counter &&
               !(isKnownAfter && isRepresentable(each, folding) &&
                 (isNext(Operator::Add, each.by) || isNext(Operator::Subtract, -each.by)))) {
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
    if (*test == 0) return step + statement.testsAfterBody;
    run.advance();
  }
  return std::nullopt;
}

bool Lowering::isWorthIt(const Folding& folding, std::size_t once) const {
  return folding.steps > 2 && folding.steps * once > folding.size + minSavedOperations;
}

}  // namespace warpjet::source
