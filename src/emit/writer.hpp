// Writes expressions: a node enters, its text is appended with no more parentheses than it needs.
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

  // From now on the node, or the input, is written as this variable.
  void name(NodeId id, std::string name);
  void nameInput(std::uint32_t input, std::string name) { inputNames_[input] = std::move(name); }

  // The matrices of turns, which are a stack, since what a loop's body names is known there alone;
  // those of the body that is being written are from `first` on.
  void countMatrix(const Packs::Matrix& matrix, std::size_t first);
  // Whether it has been counted more than once, and has no name yet.
  bool wantsName(const Packs::Matrix& matrix) const;
  void nameMatrix(const Packs::Matrix& matrix, std::string name);
  std::size_t matrixCount() const { return matrices_.size(); }
  void forgetMatrices(std::size_t first);

  // That this result of a call of a function of ours is needed, hence all of its order.
  void need(NodeId call, int result);
  int orderOf(NodeId call) const { return orders_[index(call)]; }
  // Of the variable that holds the node.
  std::string typeOf(NodeId id) const;

  bool isNamed(NodeId id) const { return names_[index(id)] != none; }
  const std::string& nameOf(NodeId id) const { return texts_[names_[index(id)]]; }
  const std::string& inputName(std::uint32_t input) const { return inputNames_[input]; }

  // The operation itself, even if the node has a name.
  void writeOperation(std::string& text, NodeId id);
  // Several nodes as a vector, even if they have names where they are a statement.
  void writeLanes(std::string& text, const Lanes& lanes, Packs::As as,
                  ops::Precedence loosest = ops::Precedence::Ternary);
  void writeMatrix(std::string& text, const Packs::Matrix& matrix);
  // A number, a vector or a matrix.
  void writeValue(std::string& text, Shape shape, std::span<const NodeId> components);

 private:
  // A spelling that is being written.
  struct Frame {
    NodeId id;
    std::string_view rest;
    bool parenthesized;
  };

  struct CountedMatrix {
    Packs::Matrix matrix;
    std::uint32_t before;  // of the same cosine, or none
    std::uint32_t text;    // its name, if it has one
  };
  static constexpr std::uint32_t isWanted = none - 1;
  // Which one it is, or none.
  std::uint32_t find(const Packs::Matrix& matrix) const;

  void write(std::string& text, NodeId id);
  void open(std::string& text, NodeId id, ops::Precedence loosest);
  void writeLeaf(std::string& text, NodeId id);
  static void writeInt(std::string& text, double value);
  void finish(std::string& text);
  const ops::Spelling& spellingOf(NodeId id) const;
  std::string_view textOf(NodeId id);
  [[gnu::noinline, gnu::cold]] std::string_view callText(NodeId id);
  void writeResult(std::string& text, NodeId id) const;
  bool isWholeInput(Shape shape, std::span<const NodeId> components) const;
  void writeRow(std::string& text, Shape shape, std::span<const NodeId> all, Packs::As as);
  void writeOperation(std::string& text, const Lanes& lanes, ops::Precedence loosest);
  void writePart(std::string& text, const Lanes& lanes);
  void writeTurn(std::string& text, const Packs::Turn& turn, ops::Precedence loosest);
  void writeProduct(std::string& text, std::string_view name, const Packs::Factors& factors);
  void writeProduct(std::string& text, const MatrixProduct& product);

  const Graph& graph_;
  const Dialect& dialect_;
  const Packs& packs_;
  std::vector<std::uint32_t> names_;  // by node index, an index into texts_
  std::vector<std::string> texts_;
  std::vector<std::string> inputNames_;
  std::vector<CountedMatrix> matrices_;
  std::vector<std::uint32_t> lastMatrixOf_;  // by cosine
  std::vector<std::uint8_t> orders_;         // by node, of calls of functions of ours
  std::set<std::string> callTexts_;          // such as `bump($0)`
  std::vector<Frame> frames_;
};

}  // namespace warpjet
