// Constant expressions, evaluated while the source is parsed: lengths of arrays, case labels, loop
// headers and indices; section 4.3.3 of GLSL ES 3.00.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "source/problems.hpp"
#include "source/tree.hpp"

namespace warpjet::source {

class Lowering;

// Works on a tree that is still growing.
class Constants {
 public:
  Constants(const Tree& tree, int version);
  ~Constants();

  // Returns true for a constant expression. Variables for which `isKnown` returns true count as
  // constants.
  template <class IsKnown>
  bool isConstant(ExpressionId expression, const IsKnown& isKnown) const;
  bool isConstant(ExpressionId expression) const {
    return isConstant(expression, [](VariableId) { return false; });
  }

  // Returns the numbers of a constant expression; empty if it isn't one, or has no value.
  std::vector<double> numbers(ExpressionId expression);
  // Returns the bits of each component of a constant expression of ints or uints; empty if they are
  // unknown.
  std::vector<std::int32_t> integers(ExpressionId expression);
  // Returns the value of a constant int or uint scalar; nullopt if it is unknown.
  std::optional<std::int32_t> integer(ExpressionId expression);

 private:
  // Returns false if the expression isn't constant even if its operands are.
  bool mayBeConstant(const Expression& node) const;

  const Tree& tree_;
  int version_;
  Problems problems_;
  std::unique_ptr<Lowering> lowering_;
};

template <class IsKnown>
bool Constants::isConstant(ExpressionId expression, const IsKnown& isKnown) const {
  std::vector<ExpressionId> open{expression};
  while (!open.empty()) {
    const Expression& node = tree_.expressions[open.back()];
    open.pop_back();
    if (!mayBeConstant(node)) return false;
    if (node.kind == Expression::Kind::Variable) {
      // A const parameter has no value yet.
      const Variable& variable = tree_.variables[node.index];
      const bool hasValue = variable.kind == Variable::Kind::Constant && variable.start != nothing;
      if (!hasValue && !isKnown(node.index)) return false;
    }
    open.insert(open.end(), node.operands.begin(), node.operands.end());
  }
  return true;
}

}  // namespace warpjet::source
