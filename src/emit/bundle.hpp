// Multiple return values of our functions: up to four are returned as a number or a vector, more as
// a struct of vec4.
#pragma once

#include <string>

#include "emit/dialect.hpp"
#include "graph/graph.hpp"

namespace warpjet {

// Returns the number of values that a function returns with all derivatives up to an order.
int resultCount(const Function& function, int order);

// Returns the name of the variant that returns derivatives up to that order: warpjetNoise3 for 0,
// warpjetNoise3Gradient for 1.
std::string nameWithDerivatives(const Function& function, int order);

struct Bundle {
  static constexpr int perPart = 4;

  std::string function;  // its `nameWithDerivatives`
  int count;

  Bundle(const Function& called, int order)
      : function(nameWithDerivatives(called, order)), count(resultCount(called, order)) {}

  bool isStruct() const { return count > perPart; }
  int parts() const { return (count + perPart - 1) / perPart; }
  static std::string partName(int part);

  std::string type(const Dialect& dialect) const;
  // Returns the suffix that selects value `i` of a variable: `.x`, or a member of the struct.
  std::string member(int i) const;
  // Returns the definition of the struct, or empty if there is none.
  std::string definition(const Dialect& dialect) const;
};

}  // namespace warpjet
