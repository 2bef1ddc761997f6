#include "emit/merge.hpp"

#include <algorithm>

namespace warpjet {

namespace {

using As = Packs::As;
using Form = Packs::Form;

class Merger {
 public:
  Merger(const Graph& graph, Packs& packs, Statements& body, std::uint32_t first,
         std::span<const std::uint32_t> levels, const Readers& readers, const EmitOptions& options)
      : maxInlineDepth_(std::min(options.maxDepth - 1, 3)),
        graph_(graph),
        packs_(packs),
        body_(body),
        first_(first),
        count_(static_cast<std::uint32_t>(body.all.size())),
        levels_(levels),
        readers_(readers) {}

  // Merges the statements of a pack, and an assignment of exactly that pack to a result, into one
  // statement. Statements are ordered by level, so that each reads only earlier ones.
  void run(bool hasPacks) {
    std::vector<std::uint32_t> firstOf(count_ + 1, none), nextOf(count_), order;
    for (std::uint32_t i = count_; i-- > 0;) {
      nextOf[i] = firstOf[levels_[i]];
      firstOf[levels_[i]] = i;
    }
    for (std::uint32_t level = 0; firstOf[level] != none; ++level) {
      for (std::uint32_t i = firstOf[level]; i != none; i = nextOf[i]) order.push_back(i);
    }
    for (const std::uint32_t i : order) {
      const std::uint32_t pack = packOf(body_.all[i]);
      if (pack != none && isLoss(packs_[pack])) packs_.dissolve(pack);
    }
    bool isShorter = hasPacks;
    // Only outside of loops: the assignments at the end of a loop's step read values, too, but
    // aren't in `readers_`.
    for (std::uint32_t i = 0; i < count_ && first_ == 0; ++i) {
      if (!isInlineScalar(body_.all[i], readers_.of(i))) continue;
      packs_.removeStatement(body_.all[i].node);
      isShorter = true;
    }
    if (!isShorter) return;
    std::vector<std::uint32_t> unitOf(count_, none);  // by statement: its merged statement
    Statements merged;
    for (const std::uint32_t i : order) {
      if (unitOf[i] == none && !isRemoved(i)) mergeOne(merged, unitOf, i);
    }
    body_ = std::move(merged);
  }

 private:
  std::uint32_t numberOf(NodeId id) const { return packs_.statementOf(id) - first_; }

  std::uint32_t packOf(const Statement& statement) const {
    return statement.node == noNode ? none : packs_.packOf(statement.node);
  }
  bool isRemoved(std::uint32_t i) const {
    return body_.all[i].node != noNode && !packs_.isStatement(body_.all[i].node);
  }

  void mergeOne(Statements& merged, std::vector<std::uint32_t>& unitOf, std::uint32_t i) {
    const auto unit = static_cast<std::uint32_t>(merged.all.size());
    Statements::Set reads = merged.emptySet();
    const auto includeReads = [&](std::uint32_t other) {
      for (const std::uint32_t each : body_.work.readsOf(other)) {
        if (!isRemoved(each)) merged.include(reads, unitOf[each]);
      }
    };
    const auto join = [&](std::uint32_t other) {
      unitOf[other] = unit;
      includeReads(other);
      for (const std::uint32_t each : body_.work.readsOf(other)) {
        if (isRemoved(each)) includeReads(each);
      }
    };
    Statement statement = body_.all[i];
    statement.pack = packOf(statement);
    if (statement.pack == none) {
      join(i);
    } else {
      const Lanes lanes = packs_[statement.pack];
      for (const NodeId id : lanes) join(numberOf(id));
      for (const std::uint32_t reader : readers_.of(numberOf(lanes[0]))) {
        if (statement.output || !assignsOnly(lanes, body_.all[reader])) continue;
        statement.output = body_.all[reader].output;
        unitOf[reader] = unit;
      }
    }
    merged.add(statement, reads);
  }

  // Returns true if a scalar is read only once, as the scalar operand of a vector operation, as in
  // `v * t1`. Then it is written inline.
  bool isInlineScalar(const Statement& statement, std::span<const std::uint32_t> readers) const {
    const NodeId id = statement.node;
    if (id == noNode || statement.output || packs_.packOf(id) != none || readers.empty())
      return false;
    const Statement& reader = body_.all[readers[0]];
    const bool isResult = reader.node == noNode;
    const std::uint32_t pack = packOf(reader);
    if (isResult ? !reader.output->shape.isVector() : pack == none) return false;
    const Lanes lanes = isResult ? Lanes(reader.output->components) : packs_[pack];
    const std::size_t statements = isResult ? 1 : static_cast<std::size_t>(lanes.count);
    const bool isOneStatement =
        std::all_of(readers.begin(), readers.end(),
                    [&](std::uint32_t other) { return packOf(body_.all[other]) == pack; });
    if (!isOneStatement || readers.size() != statements) return false;
    if (packs_.rotationOf(lanes) || packs_.productOf(lanes)) return false;
    if (packs_.chooseLayout(lanes, isResult ? As::Operand : As::Statement).form != Form::Operation)
      return false;
    int times = 0;
    for (int i = 0; i < graph_.arity(lanes[0]); ++i) {
      const Lanes operands = packs_.operandsOf(lanes, i);
      const auto isScalar = [&](NodeId operand) { return operand == id; };
      if (std::all_of(operands.begin(), operands.end(), isScalar))
        ++times;
      else if (!std::all_of(operands.begin(), operands.end(),
                            [&](NodeId operand) { return operand != id && isNamed(operand); }))
        return false;
    }
    return times == 1 && graph_.isOperation(id) && areShallow(id, maxInlineDepth_);
  }

  bool isNamed(NodeId id) const { return graph_.isLeaf(id) || packs_.isStatement(id); }

  // Returns true if the operands nest fewer than `levels` operations.
  bool areShallow(NodeId id, int levels) const {
    if (levels == 0) return false;
    for (int i = 0; i < graph_.arity(id); ++i) {
      const NodeId operand = graph_.operand(id, i);
      if (!isNamed(operand) && !(graph_.isOperation(operand) && areShallow(operand, levels - 1)))
        return false;
    }
    return true;
  }

  // Returns true if a statement does nothing but assign these lanes to a result.
  bool assignsOnly(const Lanes& lanes, const Statement& statement) const {
    return statement.node == noNode &&
           std::equal(lanes.begin(), lanes.end(), statement.output->components.begin(),
                      statement.output->components.end());
  }

  // Returns true for a pack that doesn't pay off because the packs it counted on were not made.
  // Reading a single lane costs a `.x`; packs and vectors that read all lanes save a `vec3( )`.
  bool isLoss(const Lanes& lanes) const {
    int gain = packs_.gainOf(lanes, packs_.chooseLayout(lanes, As::Statement).length);
    for (const NodeId id : lanes) {
      for (const std::uint32_t reader : readers_.of(numberOf(id))) {
        const Statement& statement = body_.all[reader];
        const bool isVector = statement.node == noNode ? !statement.output->shape.isNumber()
                                                       : packs_.packOf(statement.node) != none;
        gain += isVector ? 2 : -2;
      }
    }
    return gain <= 0;
  }

  int maxInlineDepth_;  // nested operations
  const Graph& graph_;
  Packs& packs_;
  Statements& body_;
  std::uint32_t first_, count_;
  std::span<const std::uint32_t> levels_;  // by statement
  const Readers& readers_;
};

}  // namespace

void mergeStatements(const Graph& graph, Packs& packs, Statements& body, std::uint32_t first,
                     std::span<const std::uint32_t> levels, const Readers& readers, bool hasPacks,
                     const EmitOptions& options) {
  Merger(graph, packs, body, first, levels, readers, options).run(hasPacks);
}

}  // namespace warpjet
