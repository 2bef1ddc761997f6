// Writes expressions: appends the code of a node, with no more parentheses than needed.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emit/lanes.hpp"
#include "graph/graph.hpp"

namespace warpjet {

class Writer {
 public:
  Writer(const Graph& graph, const Dialect& dialect, const Packs& packs);
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  // Writes the node, or the input, as this variable from now on.
  void name(NodeId id, std::string name);
  void nameInput(std::uint32_t input, std::string name) { inputNames_[input] = std::move(name); }

  // The following functions handle rotation matrices. These form a stack, since names defined in a
  // loop's body are visible only there; those of the body being written start at `first`.
  void countMatrix(const Packs::Matrix& matrix, std::size_t first);
  // Returns true if the matrix is used more than once and has no name yet.
  bool wantsName(const Packs::Matrix& matrix) const;
  void nameMatrix(const Packs::Matrix& matrix, std::string name);
  std::size_t matrixCount() const { return matrices_.size(); }
  void forgetMatrices(std::size_t first);

  // Requests a result of a call of a library function, and thereby all derivatives of its order.
  void requestResult(NodeId call, int result);
  int orderOf(NodeId call) const { return orders_[index(call)]; }
  // Returns the type of the variable that holds the node.
  std::string typeOf(NodeId id) const;

  bool isNamed(NodeId id) const { return names_[index(id)] != none; }
  const std::string& nameOf(NodeId id) const { return texts_[names_[index(id)]]; }
  const std::string& inputName(std::uint32_t input) const { return inputNames_[input]; }

  // Writes the operation itself, even if the node has a name.
  void writeOperation(std::string& text, NodeId id);
  // Writes several nodes as a vector, even if they have names because they are statements.
  void writeLanes(std::string& text, const Lanes& lanes, Packs::As as,
                  ops::Precedence loosest = ops::Precedence::Ternary);
  void writeMatrix(std::string& text, const Packs::Matrix& matrix);
  // Writes a number, a vector or a matrix.
  void writeValue(std::string& text, Shape shape, std::span<const NodeId> components);

 private:
  // A spelling that is partly written.
  struct Frame {
    NodeId id;
    std::string_view rest;
    bool parenthesized;
  };

  struct CountedMatrix {
    Packs::Matrix matrix;
    std::uint32_t previous;  // the preceding matrix with the same cosine, or `none`
    std::uint32_t name;      // an index into texts_; `wanted` if it should get a name; or `none`
  };
  static constexpr std::uint32_t wanted = none - 1;
  // Returns the index of the matrix, or `none`.
  std::uint32_t find(const Packs::Matrix& matrix) const;

  void write(std::string& text, NodeId id);
  void open(std::string& text, NodeId id, ops::Precedence loosest);
  void writeLeaf(std::string& text, NodeId id);
  static void writeInt(std::string& text, double value);
  void writePending(std::string& text);
  const ops::Spelling& spellingOf(NodeId id) const;
  std::string_view textOf(NodeId id);
  [[gnu::noinline, gnu::cold]] std::string_view callText(NodeId id);
  void writeResult(std::string& text, NodeId id) const;
  bool isWholeInput(Shape shape, std::span<const NodeId> components) const;
  void writeRow(std::string& text, Shape shape, std::span<const NodeId> all, Packs::As as);
  void writeOperation(std::string& text, const Lanes& lanes, ops::Precedence loosest);
  void writePart(std::string& text, const Lanes& lanes);
  void writeRotation(std::string& text, const Packs::Rotation& rotation, ops::Precedence loosest);
  void writeProduct(std::string& text, std::string_view name, const Packs::Factors& factors);
  void writeProduct(std::string& text, const MatrixProduct& product);

  const Graph& graph_;
  const Dialect& dialect_;
  const Packs& packs_;
  std::vector<std::uint32_t> names_;  // by node: an index into texts_
  std::vector<std::string> texts_;
  std::vector<std::string> inputNames_;
  std::vector<CountedMatrix> matrices_;
  std::vector<std::uint32_t> lastMatrixOf_;  // by cosine
  std::vector<std::uint8_t> orders_;         // by node, for calls of library functions
  std::set<std::string> callTexts_;          // such as `bump($0)`
  std::vector<Frame> frames_;
};

}  // namespace warpjet
