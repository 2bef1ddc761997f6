// Writes expressions: a node enters, its text is appended with no more parentheses than it needs.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

// `float`, `bool`, `vec3`, `bvec2`.
std::string typeName(ops::Type type, int size);

class Writer {
 public:
  explicit Writer(const Graph& graph)
      : graph_(graph), names_(graph.size(), unnamed), inputNames_(graph.inputCount()) {}

  // From now on the node, or the input, is written as this variable.
  void name(NodeId id, std::string name);
  void nameInput(std::uint32_t input, std::string name) { inputNames_[input] = std::move(name); }

  bool isNamed(NodeId id) const { return names_[index(id)] != unnamed; }
  const std::string& nameOf(NodeId id) const { return texts_[names_[index(id)]]; }
  const std::string& inputName(std::uint32_t input) const { return inputNames_[input]; }

  // The operation itself, even if the node has a name.
  void writeOperation(std::string& text, NodeId id);
  void writeVector(std::string& text, std::span<const NodeId> components);

 private:
  static constexpr std::uint32_t unnamed = ~std::uint32_t{0};

  // A spelling that is being written.
  struct Frame {
    NodeId id;
    std::string_view rest;
    bool parenthesized;
  };

  void write(std::string& text, NodeId id);
  void open(std::string& text, NodeId id, ops::Precedence loosest);
  void writeLeaf(std::string& text, NodeId id);
  void finish(std::string& text);
  bool isWholeInput(std::span<const NodeId> components) const;

  const Graph& graph_;
  std::vector<std::uint32_t> names_;  // by node index, an index into texts_
  std::vector<std::string> texts_;
  std::vector<std::string> inputNames_;
  std::vector<Frame> frames_;
};

}  // namespace warpjet
