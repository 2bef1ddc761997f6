// One result of a program as a function of the inputs that vary: of a box of them an interval, of a
// point a number. What does not depend on them is computed once.
#pragma once

#include <vector>

#include "eval/idioms.hpp"
#include "eval/words.hpp"
#include "ops/interval.hpp"

namespace warpjet {

class IntervalProgram {
 public:
  // Inputs that are points are constant.
  IntervalProgram(const Words& words, std::span<const Interval> inputs, std::size_t result);

  // The places of the inputs that vary and matter.
  std::span<const std::uint32_t> variables() const { return variables_; }
  // How many instructions one evaluation runs.
  std::size_t cost() const { return varying_.size() + 1; }

  // One interval or number for each variable.
  Interval range(std::span<const Interval> box);
  double value(std::span<const double> point);

 private:
  // The result is a sum of these and of constants; what cancels in it, as in p + (q - p), does not
  // widen it then.
  struct Term {
    std::uint32_t instruction;
    double factor;
    double size;  // the sum of the absolute factors that it has in the program
  };

  void findTerms(std::uint32_t root);
  void schedule(std::span<const Interval> inputs);
  Interval rangeOf(std::uint32_t instruction) const;
  double valueOf(std::uint32_t instruction) const;
  Interval total() const;

  Words words_;
  std::vector<Term> terms_;
  double roundings_ = 1;  // how often the sum of the terms is rounded
  std::vector<std::uint32_t> variables_;
  std::vector<std::uint32_t> variableInstructions_;  // the reading of each
  std::vector<std::uint32_t> varying_;               // instructions that depend on variables
  std::vector<Idiom> idioms_;                        // by instruction
  std::vector<Interval> ranges_;                     // by instruction
  std::vector<double> values_;                       // by instruction
};

}  // namespace warpjet
