// Vectors and matrices of doubles, and a fixture that compares the values of nodes with them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "algebra/derivatives.hpp"
#include "algebra/matrices.hpp"
#include "algebra/vectors.hpp"
#include "support.hpp"

namespace warpjet {

using Doubles = std::vector<double>;

// A matrix of doubles: m[column][row], as in GLSL.
using Matrix = std::vector<Doubles>;

inline Matrix toMatrix(const Doubles& components, Shape shape) {
  Matrix m(shape.columns, Doubles(shape.rows));
  for (int i = 0; i < shape.size(); ++i) m[i / shape.rows][i % shape.rows] = components[i];
  return m;
}

inline double dotOf(const Doubles& a, const Doubles& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

inline Doubles crossOf(const Doubles& a, const Doubles& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Doubles scaleBy(Doubles v, double factor) {
  for (double& x : v) x *= factor;
  return v;
}

inline Doubles sumOf(const Doubles& a, const Doubles& b) {
  Doubles total = a;
  for (std::size_t i = 0; i < b.size(); ++i) total[i] += b[i];
  return total;
}

inline Doubles unit(const Doubles& v) { return scaleBy(v, 1 / std::sqrt(dotOf(v, v))); }

class AlgebraTest : public testing::Test {
 protected:
  Graph graph;
  Differentiator differentiator{graph};
  Inputs inputs;
  std::mt19937 random{1};

  // Returns a variable and sets the values of its components.
  Value makeVariable(const std::string& name, Shape shape, const Doubles& components) {
    const Value value = variable(graph, name, shape);
    for (int i = 0; i < shape.size(); ++i) inputs[value[i].id] = components[i];
    return value;
  }
  Value makeVariable(const std::string& name, const Doubles& components) {
    return makeVariable(name, vectorOf(static_cast<int>(components.size())), components);
  }
  Expression makeVariable(const std::string& name, double number) {
    return makeVariable(name, scalarShape, {number})[0];
  }

  Doubles randomNumbers(int count) {
    Doubles numbers;
    for (int i = 0; i < count; ++i)
      numbers.push_back(std::uniform_real_distribution(-2.0, 2.0)(random));
    return numbers;
  }

  Doubles evaluateComponents(const Value& value) {
    Doubles numbers;
    for (const NodeId id : value.nodes()) numbers.push_back(evaluateNode(graph, id, inputs));
    return numbers;
  }

  void expectNear(const Value& value, const Doubles& expected, double tolerance = 1e-13) {
    const Doubles found = evaluateComponents(value);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], tolerance * std::max(1.0, std::abs(expected[i])))
          << "component " << i;
  }
  void expectNear(const Value& value, const Matrix& expected, double tolerance = 1e-13) {
    Doubles components;
    for (const Doubles& column : expected)
      components.insert(components.end(), column.begin(), column.end());
    expectNear(value, components, tolerance);
  }
};

}  // namespace warpjet
