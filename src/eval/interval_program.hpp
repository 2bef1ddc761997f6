// One result of a program as a function of the inputs that vary: maps a box to an interval, and a
// point to a number. Instructions that don't depend on these inputs are computed once.
#pragma once

#include <vector>

#include "eval/idioms.hpp"
#include "eval/words.hpp"
#include "ops/interval.hpp"

namespace warpjet {

class IntervalProgram {
 public:
  // Inputs whose range is a point are constant.
  IntervalProgram(const Words& words, std::span<const Interval> inputs, std::size_t result);

  // Returns the indices of the inputs that vary and are used.
  std::span<const std::uint32_t> variables() const { return variables_; }
  // Returns the number of instructions that one evaluation runs.
  std::size_t cost() const { return varying_.size() + 1; }

  // Takes one interval or number per variable.
  Interval range(std::span<const Interval> box);
  double value(std::span<const double> point);

 private:
  // The result is the sum of these terms, times their factors. Equal terms are combined, so that
  // terms that cancel, as in p + (q - p), don't widen the interval.
  struct Term {
    std::uint32_t instruction;
    double factor;
    double size;  // sum of the absolute factors of its occurrences
  };

  void findTerms(std::uint32_t root);
  void schedule(std::span<const Interval> inputs);
  Interval rangeOf(std::uint32_t instruction) const;
  double valueOf(std::uint32_t instruction) const;
  Interval total() const;

  Words words_;
  std::vector<Term> terms_;
  double roundings_ = 1;  // number of roundings of the sum
  std::vector<std::uint32_t> variables_;
  std::vector<std::uint32_t> variableInstructions_;  // the instruction that reads each variable
  std::vector<std::uint32_t> varying_;               // instructions that depend on variables
  std::vector<Idiom> idioms_;                        // by instruction
  std::vector<Interval> ranges_;                     // by instruction
  std::vector<double> values_;                       // by instruction
};

}  // namespace warpjet
