// Writes statements as lines of shader code.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "emit/names.hpp"
#include "emit/packs.hpp"
#include "emit/statements.hpp"
#include "emit/writer.hpp"

namespace warpjet {

// The statements to write: those outside of all loops, then those of each loop. `loops` is null if
// there are none.
struct Plan {
  const Graph& graph;
  const Dialect& dialect;
  std::span<const Output> outputs;
  std::span<const std::optional<Sum>> sums;
  const Comments& comments;
  const Packs& packs;
  const Loops* loops;
  std::vector<Statements> statements = {};
};

class StatementWriter {
 public:
  // `writer` holds the names of nodes, `temporaries` the names in use.
  StatementWriter(const Plan& plan, Writer& writer, Temporaries& temporaries)
      : plan_(plan), graph_(plan.graph), writer_(writer), temporaries_(temporaries) {}

  void reserve(std::size_t characters) { code_.reserve(characters); }
  // Names an input. If its expression is more than a variable, a temporary holds its value.
  void bindInput(std::uint32_t input, const std::string& text);
  void write() { write(plan_.statements[0]); }

  const std::string& code() const { return code_; }
  std::size_t temporaryCount() const { return temporaryCount_; }
  // Returns the number of temporaries that are vectors.
  std::size_t vectorCount() const { return vectorCount_; }

 private:
  // Begins a statement.
  void define(std::string_view type, std::string_view name);
  void begin(std::string_view form, std::string_view type, std::string_view name);

  void write(const Statements& statements);
  void writeLoop(std::uint32_t loop);
  void assignStates(std::span<const State> states);
  void compute(const Statement& statement);
  void assign(const Output& output);
  void nameMatrix(const Packs::Matrix& matrix);
  void writeComments(std::span<const NodeId> roots);
  std::optional<Packs::Rotation> rotationOf(const Statement& statement) const;

  const Plan& plan_;
  const Graph& graph_;
  Writer& writer_;
  Temporaries& temporaries_;
  std::string indent_ = "  ";
  std::string code_;
  std::size_t temporaryCount_ = 0, vectorCount_ = 0;
};

}  // namespace warpjet
