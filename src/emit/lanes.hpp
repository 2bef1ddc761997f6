// Decides how several nodes are written as the components of one vector, and how long the code is.
//
// Lanes are up to four nodes. They are written in the shortest of these forms: one number for all
// lanes, components of an existing vector, one vector operation (including cross products and
// rotations by a mat2), or a list of numbers. Everything is computed component by component, so
// every component has the same bits as its scalar code, except in dot products, rotations and
// matrix products, which a language may sum in any order.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "emit/dialect.hpp"
#include "emit/lengths.hpp"
#include "emit/products.hpp"
#include "graph/graph.hpp"

namespace warpjet {

struct Lanes {
  static constexpr int maxCount = 4;

  std::array<NodeId, maxCount> nodes{};
  int count = 0;

  Lanes() = default;
  explicit Lanes(std::span<const NodeId> all) {
    for (const NodeId id : all) add(id);
  }

  void add(NodeId id) { nodes[count++] = id; }
  NodeId operator[](int i) const { return nodes[i]; }
  const NodeId* begin() const { return nodes.data(); }
  const NodeId* end() const { return nodes.data() + count; }
};

// Records which nodes are statements, and which statements are packed into one.
class Packs {
 public:
  // The ways to write lanes: as one number for all of them, as components of an existing vector, as
  // an operation on vectors, or as a list of numbers.
  enum class Form : std::uint8_t { Number, Part, Operation, Row };
  // Lanes are written as an operand, or as the expression that a statement computes.
  enum class As : std::uint8_t { Operand, Statement };

  Packs(const Graph& graph, const Dialect& dialect, std::span<const MatrixProduct> products)
      : graph_(graph),
        language_(dialect.language),
        products_(products),
        lengths_(graph, dialect.language),
        statements_(graph.size(), none),
        places_(graph.size(), none) {}

  // Gives the node its own statement. `statement` identifies it among the statements that may be
  // packed; `unpackable` excludes it.
  void addStatement(NodeId id, std::uint32_t statement) {
    statements_[index(id)] = statement;
    lengths_.setName(id, Lengths::name);
  }
  static constexpr std::uint32_t unpackable = none - 1;
  std::uint32_t statementOf(NodeId id) const { return statements_[index(id)]; }
  bool isStatement(NodeId id) const { return statementOf(id) != none; }
  // Writes the node inline from now on.
  void removeStatement(NodeId id) {
    statements_[index(id)] = none;
    lengths_.removeName(id);
  }
  // `nodes` are all nodes to write, in ascending order; all statements must have been added.
  void measure(std::span<const NodeId> nodes) { lengths_.measure(nodes); }

  void add(const Lanes& lanes);
  void dissolve(std::uint32_t pack);
  // If true, lanes that could still be packed are measured as if they were.
  void setOptimistic(bool optimistic) { isOptimistic_ = optimistic; }

  std::uint32_t size() const { return static_cast<std::uint32_t>(lanes_.size() / Lanes::maxCount); }
  Lanes operator[](std::uint32_t pack) const;
  // Returns the pack that a node is a lane of, or `none`.
  std::uint32_t packOf(NodeId id) const {
    return places_[index(id)] == none ? none : places_[index(id)] / Lanes::maxCount;
  }

  struct Layout {
    Form form;
    int length;  // approximate, in characters
  };
  Layout chooseLayout(const Lanes& lanes, As as, int levels = Lengths::maxLevels) const;
  int lengthOfStatement(NodeId id) const {
    return lengths_.lengthOfOperation(id, Lengths::maxLevels);
  }

  // Returns how many characters are saved by one statement whose expression has this length, in
  // place of a statement per lane.
  int gainOf(const Lanes& lanes, int length) const;

  // Returns the vector and component that a node is read from, as four times the vector's key plus
  // the component; less than four if it isn't a component of a vector.
  std::uint64_t placeOf(NodeId id) const;
  // If a node is read from a vector that is one of our variables or the host's, returns the number
  // of components of that vector; 0 otherwise.
  int vectorSizeOf(NodeId id) const;
  bool isPart(const Lanes& lanes) const;
  // Returns operand i of each lane.
  Lanes operandsOf(const Lanes& lanes, int i) const;
  // Returns true if operand i is the same for all lanes and may be a scalar.
  bool takesScalar(const Lanes& lanes, int i) const;
  // The two vectors of a sum that is a dot product. A language may add its terms in any order.
  struct Factors {
    Lanes a, b;
  };
  std::optional<Factors> dotProductOf(NodeId sum) const;
  // Returns the two vectors whose cross product the three lanes are.
  std::optional<Factors> crossProductOf(const Lanes& lanes) const;
  // The matrix of a rotation by an angle, or of a reflection. `minus` has one bit per negated
  // entry, column by column.
  struct Matrix {
    NodeId cosine, sine;
    std::uint8_t minus;
    bool operator==(const Matrix&) const = default;
  };
  // Two lanes that are the point (a, b) rotated by an angle: ±a cos u ± b sin u, ±a sin u ± b cos
  // u.
  struct Rotation {
    Lanes point;
    Matrix matrix;
  };
  std::optional<Rotation> rotationOf(const Lanes& lanes) const;
  // Returns the vector-matrix product that the three lanes are, or null.
  const MatrixProduct* productOf(const Lanes& lanes) const;
  // Returns true if the lanes could share a statement and none of them is packed yet.
  bool isPackable(const Lanes& lanes) const;

 private:
  static constexpr int rowStart = 6, separator = 2;
  // The length of `mat2(t12, t13, -t13, t12) * `, with names of three characters.
  static constexpr int rotationStart = 28;
  // A vector operation must be shorter than a list by this much, since it is harder to read.
  static constexpr int margin = 4;

  int operationLength(const Lanes& lanes, int levels) const;
  bool isOperation(const Lanes& lanes) const;
  bool isNamedSineOrCosine(NodeId id) const;
  const ops::Spelling& spellingOf(const Lanes& lanes) const {
    return ops::spelling(graph_.node(lanes[0]).op, language_);
  }

  const Graph& graph_;
  ops::Language language_;
  std::span<const MatrixProduct> products_;
  Lengths lengths_;
  bool isOptimistic_ = false;
  std::vector<std::uint32_t> statements_;  // by node: the number of its statement
  std::vector<std::uint32_t> places_;      // by node: the lane that it is
  std::vector<NodeId> lanes_;              // four per pack
};

}  // namespace warpjet
