// How several nodes are written as the components of one vector, and how long that is.
//
// Lanes are up to four nodes. They are one number for all, a part of a vector that there is, one
// operation on vectors (a cross product and a turn by a mat2 among them), or a row of numbers,
// whichever is shortest. All is computed component by component, so every component has the bits of
// its own scalar text, but in dot products, turns and products with a matrix, which a language may
// add up in any order.
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
  static constexpr int most = 4;

  std::array<NodeId, most> nodes{};
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

// Which nodes are statements, and which of those share one.
class Packs {
 public:
  enum class Form : std::uint8_t { Number, Part, Operation, Row };
  // Whether lanes are read, or are what a statement computes.
  enum class As : std::uint8_t { Operand, Statement };

  Packs(const Graph& graph, const Dialect& dialect, std::span<const MatrixProduct> products)
      : graph_(graph),
        language_(dialect.language),
        products_(products),
        lengths_(graph, dialect.language),
        numbers_(graph.size(), none),
        places_(graph.size(), none) {}

  // The node has a statement of its own, with that number among those that might be shared.
  void addStatement(NodeId id, std::uint32_t number) {
    numbers_[index(id)] = number;
    lengths_.setName(id, Lengths::name);
  }
  static constexpr std::uint32_t never = none - 1;
  std::uint32_t numberOf(NodeId id) const { return numbers_[index(id)]; }
  bool isStatement(NodeId id) const { return numberOf(id) != none; }
  // The node is written where it is read instead.
  void removeStatement(NodeId id) {
    numbers_[index(id)] = none;
    lengths_.removeName(id);
  }
  // `nodes` are all that are written, ascending, and all statements are there.
  void measure(std::span<const NodeId> nodes) { lengths_.measure(nodes); }

  void add(const Lanes& lanes);
  void dissolve(std::uint32_t pack);
  // Lanes that hope for a statement count as if they had one.
  void setHopes(bool hopes) { hopes_ = hopes; }

  std::uint32_t size() const { return static_cast<std::uint32_t>(lanes_.size() / Lanes::most); }
  Lanes operator[](std::uint32_t pack) const;
  // What a node is a lane of, or none.
  std::uint32_t packOf(NodeId id) const {
    return places_[index(id)] == none ? none : places_[index(id)] / Lanes::most;
  }

  struct Written {
    Form form;
    int length;  // in characters, about
  };
  Written written(const Lanes& lanes, As as, int levels = Lengths::deepest) const;
  int lengthOfStatement(NodeId id) const { return lengths_.ofOperation(id, Lengths::deepest); }

  // Which component of which vector a node is, as four times the vector's key and the component;
  // fewer than four if it is none.
  std::uint64_t placeOf(NodeId id) const;
  // How many components that vector has, if it is a variable of ours or of the host.
  int sizeAround(NodeId id) const;
  bool isPart(const Lanes& lanes) const;
  // The i-th operand of each.
  Lanes operandsOf(const Lanes& lanes, int i) const;
  // Whether the i-th operand of lanes is the same for all, and may be one number.
  bool takesNumber(const Lanes& lanes, int i) const;
  // The vectors whose dot product a sum is, which a language may add up in any order.
  struct Factors {
    Lanes a, b;
  };
  std::optional<Factors> factorsOf(NodeId sum) const;
  // The vectors whose cross product three lanes are.
  std::optional<Factors> crossedBy(const Lanes& lanes) const;
  // Of a turn by an angle, or a reflection. `minus` has a bit for each entry that is negated,
  // column by column.
  struct Matrix {
    NodeId cosine, sine;
    std::uint8_t minus;
    bool operator==(const Matrix&) const = default;
  };
  // The point (a, b) whose turn by an angle two lanes are: ±a cos u ± b sin u, ±a sin u ± b cos u.
  struct Turn {
    Lanes point;
    Matrix matrix;
  };
  std::optional<Turn> turnOf(const Lanes& lanes) const;
  // The vector times a matrix that three lanes are, or null.
  const MatrixProduct* productOf(const Lanes& lanes) const;
  // Whether all could share a statement that none of them shares.
  bool isHope(const Lanes& lanes) const;

 private:
  static constexpr int rowStart = 6, separator = 2;
  // Of `mat2(t12, t13, -t13, t12) * `, a name being three long.
  static constexpr int turnStart = 28;
  // An operation that is hardly shorter than a row is read less well.
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
  bool hopes_ = false;
  std::vector<std::uint32_t> numbers_;  // by node, of its statement
  std::vector<std::uint32_t> places_;   // by node, which lane it is
  std::vector<NodeId> lanes_;           // four for each pack
};

}  // namespace warpjet
