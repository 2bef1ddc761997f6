#include "emit/packs.hpp"

#include <algorithm>

#include "emit/merge.hpp"

namespace warpjet {

namespace {

using As = Packs::As;
using Form = Packs::Form;

// Chooses the packs of one body, whose statements are numbered from `first`.
class Packer {
 public:
  Packer(const Graph& graph, Packs& packs, const Statements& body, std::uint32_t first)
      : graph_(graph),
        packs_(packs),
        body_(body),
        first_(first),
        count_(static_cast<std::uint32_t>(body.all.size())),
        levels_(count_),
        readers_(body.work) {
    for (std::uint32_t i = 0; i < count_; ++i) {
      for (const std::uint32_t read : body.work.readsOf(i))
        levels_[i] = std::max(levels_[i], levels_[read] + 1);
    }
  }

  // Returns true if it has made any packs.
  bool run() {
    packs_.setOptimistic(true);
    const std::uint32_t first = packs_.size();
    for (const Statement& statement : body_.all) {
      if (statement.node == noNode && statement.output->shape.isVector())
        packParts(Lanes(statement.output->components), As::Operand);
    }
    for (std::uint32_t i = 0; i < count_; ++i) packRotationsBy(i);
    for (std::uint32_t i = first; i < packs_.size(); ++i) {
      const Lanes lanes = packs_[i];
      packParts(lanes, As::Statement);
      packReaders(lanes);
    }
    packs_.setOptimistic(false);
    return packs_.size() > first;
  }

  std::span<const std::uint32_t> levels() const { return levels_; }
  const Readers& readers() const { return readers_; }

 private:
  // The max number of readers of a statement that are searched.
  static constexpr std::size_t maxReaders = 8;

  // Returns the index of the node's statement in this body; `count_` or more if it can't be packed
  // here.
  std::uint32_t numberOf(NodeId id) const { return packs_.statementOf(id) - first_; }

  // Packs the lanes if possible. Operands of a statement are on lower levels than the statement,
  // and all lanes are raised to the same level, so a pack never depends on itself.
  bool pack(const Lanes& lanes) {
    if (lanes.count < 2 || !packs_.isPackable(lanes)) return false;
    std::uint32_t highest = 0;
    for (const NodeId id : lanes) {
      if (numberOf(id) >= count_) return false;
      highest = std::max(highest, levels_[numberOf(id)]);
    }
    for (const NodeId id : lanes) {
      if (!canRise(numberOf(id), highest)) return false;
    }
    for (const NodeId id : lanes) levels_[numberOf(id)] = highest;
    packs_.add(lanes);
    return true;
  }

  bool canRise(std::uint32_t i, std::uint32_t level) const {
    if (levels_[i] == level) return true;
    const auto readers = readers_.of(i);
    return readers.size() <= maxReaders &&
           std::all_of(readers.begin(), readers.end(),
                       [&](std::uint32_t reader) { return levels_[reader] > level; });
  }

  // Packs pairs that are rotated by the angle whose cosine this is.
  void packRotationsBy(std::uint32_t cosine) {
    const NodeId id = body_.all[cosine].node;
    if (id == noNode || !graph_.is(id, ops::find("cos"))) return;
    const auto readers = someReadersOf(cosine);
    for (const std::uint32_t x : readers) {
      for (const std::uint32_t y : readers) {
        const std::array lanes{body_.all[x].node, body_.all[y].node};
        if (x != y && lanes[0] != noNode && lanes[1] != noNode && packs_.rotationOf(Lanes(lanes)))
          pack(Lanes(lanes));
      }
    }
  }

  // Packs those operands of a vector operation that could be vectors.
  void packParts(const Lanes& lanes, As as) {
    if (lanes.count < 2 || (as == As::Operand && pack(lanes))) return;
    if (packs_.chooseLayout(lanes, as).form != Form::Operation || packs_.productOf(lanes)) return;
    if (const auto rotation = packs_.rotationOf(lanes))
      return packParts(rotation->point, As::Operand);
    for (int i = 0; i < graph_.arity(lanes[0]); ++i)
      packParts(packs_.operandsOf(lanes, i), As::Operand);
  }

  // Packs a reader of the first lane with the most similar reader of each other lane.
  void packReaders(const Lanes& lanes) {
    for (const std::uint32_t reader : readersOf(lanes[0])) {
      Lanes similar;
      similar.add(body_.all[reader].node);
      if (similar[0] == noNode) continue;
      for (int i = 1; i < lanes.count; ++i) addMostSimilar(similar, lanes[i]);
      pack(similar);
    }
  }

  void addMostSimilar(Lanes& lanes, NodeId read) const {
    NodeId best = noNode;
    int maxGain = 0;
    for (const std::uint32_t reader : readersOf(read)) {
      Lanes extended = lanes;
      extended.add(body_.all[reader].node);
      if (body_.all[reader].node == noNode || !packs_.isPackable(extended)) continue;
      const auto [form, length] = packs_.chooseLayout(extended, As::Statement);
      if (form != Form::Operation) continue;
      const int gain = packs_.gainOf(extended, length);
      if (gain <= maxGain) continue;
      maxGain = gain;
      best = body_.all[reader].node;
    }
    if (best != noNode) lanes.add(best);
  }

  // Returns the first `maxReaders` readers.
  std::span<const std::uint32_t> readersOf(NodeId id) const { return someReadersOf(numberOf(id)); }
  std::span<const std::uint32_t> someReadersOf(std::uint32_t i) const {
    const auto all = readers_.of(i);
    return all.first(std::min(all.size(), maxReaders));
  }

  const Graph& graph_;
  Packs& packs_;
  const Statements& body_;
  std::uint32_t first_, count_;
  std::vector<std::uint32_t> levels_;  // by statement
  Readers readers_;
};

}  // namespace

void packStatements(const Graph& graph, std::span<const NodeId> nodes, Packs& packs,
                    std::vector<Statements>& bodies, const EmitOptions& options) {
  std::uint32_t number = 0;
  for (const Statements& body : bodies) {
    for (const auto& [id, output, pack] : body.all) {
      const bool canBePacked =
          id != noNode && !output && !graph.isLibraryCall(id) && graph.type(id) == ops::Type::Float;
      if (id != noNode) packs.addStatement(id, canBePacked ? number : Packs::unpackable);
      ++number;
    }
  }
  packs.measure(nodes);
  if (!options.vectors) return;
  number = 0;
  for (Statements& body : bodies) {
    const auto count = static_cast<std::uint32_t>(body.all.size());
    Packer packer(graph, packs, body, number);
    const bool hasPacks = packer.run();
    mergeStatements(graph, packs, body, number, packer.levels(), packer.readers(), hasPacks,
                    options);
    number += count;
  }
}

}  // namespace warpjet
