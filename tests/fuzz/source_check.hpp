// Checks of the fuzz targets of source front ends: any text results in one message with its
// location, or in listings whose operands precede their use.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fuzz/require.hpp"
#include "source/source.hpp"

namespace warpjet::source {

inline void requireMessage(const std::string& problem) {
  require(problem.starts_with("line "), "a message starts with its line", problem);
  require(problem.find(", column ") != problem.npos, "a message has its column", problem);
  const bool isEnded = problem.find(".\n") != problem.npos || problem.find("?\n") != problem.npos;
  require(isEnded, "the first line of a message ends with . or ?", problem);
  require(problem.ends_with('^'), "a message ends with a caret", problem);
  require(problem.size() < 2000, "a message is short", std::to_string(problem.size()));
}

// Checks a listing: each operand precedes its use, and nothing that belongs to a loop or a function
// is used outside of it.
class ListingCheck {
 public:
  explicit ListingCheck(const Listing& listing)
      : words_(listing.words), constants_(listing.constants) {
    while (at_ < words_.size()) readOperation(static_cast<Code>(next()));
    require(openLoops_.empty() && !isInRoutine_, "loops and functions end");
    for (const std::uint32_t result : listing.results) requireDefined(result);
    for (const double value : constants_)
      require(value >= -3.5e38 && value <= 3.5e38, "a constant is a float", printExactly(value));
  }

 private:
  // A loop whose body is being read: the index of the first value in it, and the number of its
  // states.
  struct OpenLoop {
    std::size_t first;
    std::uint32_t states;
  };
  struct Routine {
    std::uint32_t arguments, results;
  };

  void readOperation(Code code) {
    switch (code) {
      case Code::Constant:
      case Code::Whole:
        require(next() < constants_.size(), "a constant exists");
        return define(1);
      case Code::Argument:
      case Code::Uniform:
        at_ += 3;
        return define(1);
      case Code::Parameter:
        require(next() < routines_.back().arguments, "a parameter exists");
        return define(1);
      case Code::Component:
        requireDefined(next());
        at_ += 2;
        return define(1);
      case Code::ImageSize:
        ++at_;
        return define(1);
      case Code::Texel:
      case Code::FetchedTexel:
        ++at_;
        requireDefined(next());
        return define(1);
      case Code::Fold: {
        require(next() > 0, "a loop has steps");
        const std::uint32_t states = next();
        readOperands(states);
        openLoops_.push_back({isDefined_.size(), states});
        return define(states + 1);
      }
      case Code::Next: {
        require(!openLoops_.empty(), "a loop has begun");
        const auto [first, states] = openLoops_.back();
        openLoops_.pop_back();
        readOperands(states);
        std::fill(isDefined_.begin() + static_cast<std::ptrdiff_t>(first), isDefined_.end(), false);
        return define(states);
      }
      case Code::Define: {
        require(!isInRoutine_ && isDefined_.empty(), "functions come first");
        const std::uint32_t arguments = next();
        routines_.push_back({arguments, 0});
        require(next() <= arguments, "a function cannot have more derivatives than arguments");
        isInRoutine_ = true;
        return;
      }
      case Code::End:
        require(isInRoutine_ && openLoops_.empty(), "a function has begun");
        isInRoutine_ = false;
        readOperands(routines_.back().results = next());
        isDefined_.clear();
        return;
      case Code::Call: {
        const std::uint32_t routine = next();
        require(routine < routines_.size() - isInRoutine_, "a function precedes its calls");
        const std::uint32_t count = next();
        require(count == routines_[routine].arguments, "a call has every argument");
        readOperands(count);
        return define(routines_[routine].results);
      }
      default:
        require(codeNames[static_cast<std::size_t>(code)][0] != '\0', "an operation has a name",
                std::to_string(static_cast<int>(code)));
        readOperands(next());
        return define(1);
    }
  }

  std::uint32_t next() {
    require(at_ < words_.size(), "a listing ends with an operation");
    return words_[at_++];
  }
  void define(std::uint32_t count) { isDefined_.resize(isDefined_.size() + count, true); }
  void readOperands(std::uint32_t count) {
    while (count-- > 0) requireDefined(next());
  }
  void requireDefined(std::uint32_t operand) {
    require(operand < isDefined_.size() && isDefined_[operand], "an operand precedes its use",
            std::to_string(operand) + " of " + std::to_string(isDefined_.size()));
  }

  std::span<const std::uint32_t> words_;
  std::span<const double> constants_;
  std::size_t at_ = 0;
  std::vector<bool> isDefined_;
  std::vector<OpenLoop> openLoops_;
  bool isInRoutine_ = false;
  std::vector<Routine> routines_;
};

inline void check(Source source) {
  if (!source.problem().empty()) return requireMessage(source.problem());
  const std::vector<FunctionHead> functions = source.functions();
  if (functions.empty()) return;
  // The last function, since it can call all others.
  const Listing listing = source.lower(static_cast<int>(functions.back().number), 3);
  if (!source.problem().empty()) return requireMessage(source.problem());
  ListingCheck{listing};
}

}  // namespace warpjet::source
