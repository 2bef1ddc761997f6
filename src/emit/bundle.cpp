#include "emit/bundle.hpp"

#include "graph/multi_index.hpp"

namespace warpjet {

int resultCount(const Function& function, int order) {
  return function.values * MultiIndices::countUpTo(function.variables, order);
}

std::string nameWithDerivatives(const Function& function, int order) {
  switch (order) {
    case 0:
      return function.name;
    case 1:
      return function.name + "Gradient";
    case 2:
      return function.name + "Hessian";
    default:
      return function.name + "Order" + std::to_string(order);
  }
}

std::string Bundle::partName(int part) { return "part" + std::to_string(part); }

std::string Bundle::type(const Dialect& dialect) const {
  if (isStruct()) return function + "Results";
  return std::string(dialect.typeName(ops::Type::Float, vectorOf(count)));
}

std::string Bundle::member(int i) const {
  const std::string component{'.', "xyzw"[i % perPart]};
  if (isStruct()) return '.' + partName(i / perPart) + component;
  return count == 1 ? "" : component;
}

std::string Bundle::definition(const Dialect& dialect) const {
  if (!isStruct()) return {};
  const std::string_view vec4 = dialect.typeName(ops::Type::Float, vectorOf(perPart));
  std::string members;
  for (int part = 0; part < parts(); ++part)
    appendExpanded(members, dialect.member, {vec4, partName(part)});
  return expand(dialect.structure, {type(dialect), members});
}

}  // namespace warpjet
