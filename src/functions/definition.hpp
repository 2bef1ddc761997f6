// Our own functions. Shader code defines such a function once, however often it is called, and a
// call returns a value together with its derivatives, so that they share their work. The body is
// defined once, as nodes, from which its shader source, derivatives of every order and evaluation
// on the CPU follow.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "graph/expression.hpp"

namespace warpjet {

class Library;

// A few numbers: the arguments of a function, or its values. Not a std::vector, which would
// generate more code.
class Numbers {
 public:
  static constexpr std::size_t maxArguments = 16;

  Numbers() = default;
  Numbers(std::initializer_list<Expression> all) {
    for (const Expression x : all) push_back(x);
  }

  void push_back(Expression x) { items_[size_++] = x; }
  std::size_t size() const { return size_; }
  Expression& operator[](std::size_t i) { return items_[i]; }
  const Expression& operator[](std::size_t i) const { return items_[i]; }
  Expression* begin() { return items_.data(); }
  Expression* end() { return begin() + size_; }
  const Expression* begin() const { return items_.data(); }
  const Expression* end() const { return begin() + size_; }

 private:
  std::array<Expression, maxArguments> items_{};
  std::size_t size_ = 0;
};

// Makes the first letter upper case, for names such as warpjetNoise3.
inline std::string capitalize(std::string_view text) {
  std::string name(text);
  name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

struct Definition {
  // Computes the values from the arguments. May call other functions of the library.
  using Body = Numbers (*)(Library&, std::uint32_t settings, const Numbers& arguments);
  // Returns the graph of a recorded word stream, and sets its results.
  using Reader = Graph (*)(const std::vector<std::uint32_t>& words, std::vector<NodeId>& results);
  // Recreates the definition from its settings.
  using Maker = Definition (*)(std::uint32_t settings);

  // Functions are identified by name.
  Function function;
  // Null if nodes can't express the function: then each language has its own source for it, and
  // there are no derivatives.
  Body body = nullptr;
  // An argument of `body`.
  std::uint32_t settings = 0;
  // Bounds that each value is known to be within.
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  // A bound on the magnitude of each first derivative.
  double maxSlope = std::numeric_limits<double>::infinity();

  // The names of arguments: variables first, then the other arguments.
  static constexpr std::string_view variableNames[] = {"x", "y", "z", "w"};
  static constexpr std::string_view noiseParameters[] = {"seed",  "lacunarity", "gain", "cellX",
                                                         "cellY", "cellZ",      "cellW"};
  static constexpr std::string_view imageParameters[] = {"image", "width", "height",
                                                         "wrapX", "wrapY", "isNearest"};
  static constexpr std::string_view recordedNames[Numbers::maxArguments] = {
      "x0", "x1", "x2",  "x3",  "x4",  "x5",  "x6",  "x7",
      "x8", "x9", "x10", "x11", "x12", "x13", "x14", "x15"};
  const std::string_view* parameters = noiseParameters;
  Maker maker = nullptr;
  // Used instead of a body written in C++: the word stream of a module whose inputs are the
  // arguments, and the function that reads it.
  std::vector<std::uint32_t> words = {};
  Reader reader = nullptr;

  bool hasBody() const { return body || reader; }

  std::string_view argumentName(int i) const {
    if (reader) return recordedNames[i];
    return i < function.variables ? variableNames[i] : parameters[i - function.variables];
  }
  Shape argumentShape(int i) const {
    return argumentName(i) == imageParameters[0] ? imageShape : scalarShape;
  }
};

}  // namespace warpjet
