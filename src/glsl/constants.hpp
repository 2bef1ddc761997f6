// Numbers that are known while a text is read, for lengths of arrays, labels of cases, heads of
// loops and indices: constant expressions, section 4.3.3 of GLSL ES 3.00.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "glsl/source.hpp"
#include "glsl/tree.hpp"

namespace warpjet::glsl {

class Lowering;

// Of a tree that is still growing.
class Constants {
 public:
  Constants(const Tree& tree, int version);
  ~Constants();

  // Variables of which `isKnown` holds count as constant too.
  template <class IsKnown>
  bool isConstant(ExpressionId expression, const IsKnown& isKnown) const;
  bool isConstant(ExpressionId expression) const {
    return isConstant(expression, [](VariableId) { return false; });
  }

  // Of a constant expression of ints or uints, the bits of each; empty where they are not known.
  std::vector<std::int32_t> wholes(ExpressionId expression);
  // Of one number.
  std::optional<std::int32_t> whole(ExpressionId expression);

 private:
  // What an expression of operands consists of, unless it is none of constants whatever these are.
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
      // A parameter that is const has no value yet.
      const Variable& variable = tree_.variables[node.index];
      const bool hasValue = variable.kind == Variable::Kind::Constant && variable.start != nothing;
      if (!hasValue && !isKnown(node.index)) return false;
    }
    open.insert(open.end(), node.operands.begin(), node.operands.end());
  }
  return true;
}

}  // namespace warpjet::glsl
