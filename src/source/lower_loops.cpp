// Loops: the loops of the source, and unrolling.
#include <cmath>

#include "source/loops.hpp"
#include "source/lower.hpp"

namespace warpjet::source {

namespace {

// The limit for loops whose end is known.
constexpr int maxUnrolledIterations = 20'000;
// Without the option maxIterations: the limit for loops whose end is known only when the shader
// runs.
constexpr int maxUnknown = 1'000;
constexpr const char* endsUnknown =
    "the number of iterations of this loop is known only when the shader runs; count to a constant "
    "and break, or set the option maxIterations";
// The limit for loops that can't stay loops, if others run until they end.
constexpr int maxUnrolledUnknown = 256;

std::string cutOffMessage() {
  // Up to two states say that the loop or the function has ended.
  return "only the shader knows where this loop ends, and it can't stay a loop there, since it "
         "changes more than about " +
         std::to_string(maxStates - 2) + " numbers or is nested more than " +
         std::to_string(maxFoldDepth) + " deep, so it is cut off after " +
         std::to_string(maxUnrolledUnknown) +
         " iterations; let it change fewer numbers, such as a shorter array, or set the option "
         "maxIterations (1 to " +
         std::to_string(maxIterationLimit) + ")";
}

}  // namespace

// Counts an enclosing loop whose end only the shader knows. Nested ones multiply `maxIterations`,
// so that they can't all stay loops, and are too long if they don't. Returns the message if there
// are too many.
std::string Lowering::enterUnknown() {
  ++unknownLoops_;
  const auto product = [&](int iterations) {
    return std::pow(iterations, static_cast<double>(unknownLoops_));
  };
  if (maxIterations_ <= 0 || product(maxIterations_) <= maxFoldedSteps) return {};
  int allowed = maxIterations_;
  while (product(allowed) > maxFoldedSteps) --allowed;
  std::string factors = std::to_string(maxIterations_);
  for (std::size_t i = 1; i < unknownLoops_; ++i) factors += " * " + std::to_string(maxIterations_);
  return "nested loops whose ends only the shader knows multiply the option maxIterations: "
         "expected "
         "at most " +
         std::to_string(maxFoldedSteps) + " iterations in all, got " + factors + " = " +
         std::to_string(static_cast<std::int64_t>(product(maxIterations_))) +
         "; set it to at most " + std::to_string(allowed) + ", or less if they are nested deeper";
}

void Lowering::loop(const Statement& statement) {
  execute(statement.children[0]);
  const Id no = number(Base::Bool, 0);
  const Slot broken = store_.allocate(1, no), continued = store_.allocate(1, no);
  breakables_.push_back({broken, continued, false});
  if (!foldLoop(statement)) unroll(statement);
  breakables_.pop_back();
}

// Returns true if only a break or a return can end the loop.
bool Lowering::hasNoEnd(const Statement& statement) const {
  if (statement.expression == nothing) return true;
  const Expression& test = tree_.expressions[statement.expression];
  return test.kind == Expression::Kind::Constant && test.value != 0;
}

// Unrolls a loop. If it is unknown whether there is another iteration, a branch is opened that
// contains this iteration and all following ones, so that counters remain known. The branches are
// closed at the end, in reverse order.
void Lowering::unroll(const Statement& statement) {
  const Id no = number(Base::Bool, 0);
  std::vector<Id> conditions;
  const auto enter = [&](Id condition) {
    conditions.push_back(condition);
    store_.open();
  };
  const Problems before = problems_;
  // Counts the iterations of which only the shader knows whether they are reached. The first
  // iteration of a `do` counts, too.
  int unknown = statement.testsAfterBody;
  const std::size_t unknownLoops = unknownLoops_;
  const auto enterOnce = [&] {
    if (unknownLoops_ != unknownLoops) return;
    std::string tooMany = enterUnknown();
    if (tooMany.empty()) return;
    // Unrolled, an enclosing loop may have a known end.
    if (unknownFolds_ > 0)
      problems_.add(statement.location, std::move(tooMany));
    else
      problems_.addFinal(statement.location, std::move(tooMany));
  };
  const bool isEndless = hasNoEnd(statement), rejectsUnknown = maxIterations_ == rejectUnknown;
  const int limit = maxIterations_ == untilEnd ? maxUnrolledUnknown : maxIterations_;
  const auto cutOff = [&] {
    if (maxIterations_ == untilEnd) cutOff_.add(statement.location, cutOffMessage());
  };
  for (int iteration = 0; !exceedsLimits(statement.location); ++iteration) {
    if (iteration > maxUnrolledIterations) {
      problems_.add(statement.location, "this loop has not ended after " +
                                            std::to_string(maxUnrolledIterations) + " iterations");
      break;
    }
    if (statement.expression != nothing && (iteration > 0 || !statement.testsAfterBody)) {
      const Id test = condition(statement.expression);
      if (recorder_.isFalse(test) || recorder_.isUndefined(test)) break;
      if (!recorder_.isConstant(test)) {
        if (rejectsUnknown) {
          problems_.add(statement.location, endsUnknown);
          break;
        }
        if (unknown++ == limit) {
          cutOff();
          break;
        }
        enterOnce();
        enter(test);
      }
    }
    const std::size_t start = store_.now();
    execute(statement.children[2]);
    store_.set(breakables_.back().continued, no);
    const Id isOver = stopCondition();
    if (recorder_.isTrue(isOver)) break;
    if (!recorder_.isConstant(isOver)) {
      if (isEndless && !rejectsUnknown && iteration + 1 >= limit) {
        cutOff();
        break;
      }
      if (isEndless) enterOnce();
      if (isEndless && rejectsUnknown && ++unknown > maxUnknown)
        problems_.add(statement.location, endsUnknown);
      enter(recorder_.logicalNot(isOver));
      resume();
      assume(isOver, false, start);
    }
    execute(statement.children[1]);
  }
  unknownLoops_ = unknownLoops;
  // Reports a loop that ran until it exceeded a limit.
  if (problems_.any() && !before.any() && isEndless && unknown > 1 && rejectsUnknown) {
    problems_ = before;
    problems_.add(statement.location, endsUnknown);
  }
  for (std::size_t i = conditions.size(); i-- > 0;) merge(conditions[i], store_.close(), {});
}

}  // namespace warpjet::source
