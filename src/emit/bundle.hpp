// How a function of ours gives several numbers at once: up to four as a number or a vector, more as
// a struct of vec4.
#pragma once

#include <string>

#include "emit/dialect.hpp"
#include "graph/graph.hpp"

namespace warpjet {

// How many numbers a function gives with all derivatives up to an order.
int resultCount(const Function& function, int order);

// The name of the function that gives so many derivatives: warpjetNoise3, warpjetNoise3Gradient.
std::string nameWithDerivatives(const Function& function, int order);

struct Bundle {
  static constexpr int perPart = 4;

  std::string function;  // its name with derivatives
  int count;

  Bundle(const Function& given, int order)
      : function(nameWithDerivatives(given, order)), count(resultCount(given, order)) {}

  bool isStruct() const { return count > perPart; }
  int parts() const { return (count + perPart - 1) / perPart; }
  static std::string partName(int part);

  std::string type(const Dialect& dialect) const;
  // What follows the name of a variable where its number `i` is read.
  std::string member(int i) const;
  // The struct itself, or nothing.
  std::string definition(const Dialect& dialect) const;
};

}  // namespace warpjet
