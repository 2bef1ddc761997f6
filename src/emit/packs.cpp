#include "emit/packs.hpp"

#include <algorithm>

namespace warpjet {

namespace {

using As = Packs::As;
using Form = Packs::Form;

// Packs the statements of one body, which are numbered from `first`.
class Packer {
 public:
  Packer(const Graph& graph, Packs& packs, Statements& body, std::uint32_t first,
         const EmitOptions& options)
      : maxInlineDepth_(std::min(options.maxDepth - 1, 3)),
        graph_(graph),
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

  void run() {
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
    merge(packs_.size() > first);
  }

 private:
  // The length of a statement without its expression: `  float t12 = ;` and the line's end, or `
  // vec3 …`.
  static constexpr int frame = 15;
  // The max number of readers of a statement that are searched.
  static constexpr std::size_t maxReaders = 8;

  // At least `count_` for statements that can't be packed here.
  std::uint32_t numberOf(NodeId id) const { return packs_.numberOf(id) - first_; }

  // Operands of a statement are on lower levels than the statement, and all lanes are on the same
  // level, so a pack never depends on itself.
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
    if (const auto turn = packs_.rotationOf(lanes)) return packParts(turn->point, As::Operand);
    for (int i = 0; i < graph_.arity(lanes[0]); ++i)
      packParts(packs_.operandsOf(lanes, i), As::Operand);
  }

  // Packs a reader of the first lane with the most similar reader of each other lane.
  void packReaders(const Lanes& lanes) {
    for (const std::uint32_t reader : readersOf(lanes[0])) {
      Lanes found;
      found.add(body_.all[reader].node);
      if (found[0] == noNode) continue;
      for (int i = 1; i < lanes.count; ++i) addMostSimilar(found, lanes[i]);
      pack(found);
    }
  }

  void addMostSimilar(Lanes& lanes, NodeId read) const {
    NodeId best = noNode;
    int most = 0;
    for (const std::uint32_t reader : readersOf(read)) {
      Lanes with = lanes;
      with.add(body_.all[reader].node);
      if (body_.all[reader].node == noNode || !packs_.isPackable(with)) continue;
      const auto [form, length] = packs_.chooseLayout(with, As::Statement);
      if (form != Form::Operation) continue;
      const int gain = gainOf(with, length);
      if (gain <= most) continue;
      most = gain;
      best = body_.all[reader].node;
    }
    if (best != noNode) lanes.add(best);
  }

  // The first `maxReaders` readers.
  std::span<const std::uint32_t> readersOf(NodeId id) const { return someReadersOf(numberOf(id)); }
  std::span<const std::uint32_t> someReadersOf(std::uint32_t i) const {
    const auto all = readers_.of(i);
    return all.first(std::min(all.size(), maxReaders));
  }

  // The characters saved by one statement of this length in place of one per lane.
  int gainOf(const Lanes& lanes, int length) const {
    int gain = -frame - length;
    for (const NodeId id : lanes) gain += frame + packs_.lengthOfStatement(id);
    return gain;
  }

  // Merges the statements of a pack, and an assignment of exactly that pack to a result, into one
  // statement. Statements are ordered by level, so that each reads only earlier ones.
  void merge(bool hasPacks) {
    std::vector<std::uint32_t> firstOf(count_ + 1, none), nextOf(count_), order;
    for (std::uint32_t i = count_; i-- > 0;) {
      nextOf[i] = firstOf[levels_[i]];
      firstOf[levels_[i]] = i;
    }
    for (std::uint32_t level = 0; firstOf[level] != none; ++level) {
      for (std::uint32_t i = firstOf[level]; i != none; i = nextOf[i]) order.push_back(i);
    }
    for (const std::uint32_t i : order) {
      const std::uint32_t found = packOf(body_.all[i]);
      if (found != none && isLoss(packs_[found])) packs_.dissolve(found);
    }
    bool isShorter = hasPacks;
    // The end of a loop's step reads values too, but isn't in `readers_`; so bodies of loops are
    // left out.
    for (std::uint32_t i = 0; i < count_ && first_ == 0; ++i) {
      if (!isInlineScalar(body_.all[i], readers_.of(i))) continue;
      packs_.removeStatement(body_.all[i].node);
      isShorter = true;
    }
    if (!isShorter) return;
    std::vector<std::uint32_t> unitOf(count_, none);
    Statements merged;
    for (const std::uint32_t i : order) {
      if (unitOf[i] == none && !isRemoved(i)) mergeOne(merged, unitOf, i);
    }
    body_ = std::move(merged);
  }

  std::uint32_t packOf(const Statement& statement) const {
    return statement.node == noNode ? none : packs_.packOf(statement.node);
  }
  bool isRemoved(std::uint32_t i) const {
    return body_.all[i].node != noNode && !packs_.isStatement(body_.all[i].node);
  }

  void mergeOne(Statements& merged, std::vector<std::uint32_t>& unitOf, std::uint32_t i) {
    const auto unit = static_cast<std::uint32_t>(merged.all.size());
    Statements::Set reads = merged.emptySet();
    const auto read = [&](std::uint32_t other) {
      for (const std::uint32_t each : body_.work.readsOf(other)) {
        if (!isRemoved(each)) merged.include(reads, unitOf[each]);
      }
    };
    const auto join = [&](std::uint32_t other) {
      unitOf[other] = unit;
      read(other);
      for (const std::uint32_t each : body_.work.readsOf(other)) {
        if (isRemoved(each)) read(each);
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

  // True if a scalar is read by a single statement, once, as the scalar operand of a vector
  // operation, as in `v * t1`: then it is written inline.
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
    const bool isOne = std::all_of(readers.begin(), readers.end(), [&](std::uint32_t other) {
      return packOf(body_.all[other]) == pack;
    });
    if (!isOne || readers.size() != statements) return false;
    if (packs_.rotationOf(lanes) || packs_.productOf(lanes)) return false;
    if (packs_.chooseLayout(lanes, isResult ? As::Operand : As::Statement).form != Form::Operation)
      return false;
    int times = 0;
    for (int i = 0; i < graph_.arity(lanes[0]); ++i) {
      const Lanes operands = packs_.operandsOf(lanes, i);
      const auto isIt = [&](NodeId operand) { return operand == id; };
      if (std::all_of(operands.begin(), operands.end(), isIt))
        ++times;
      else if (!std::all_of(operands.begin(), operands.end(),
                            [&](NodeId operand) { return operand != id && isNamed(operand); }))
        return false;
    }
    return times == 1 && graph_.isOperation(id) && areShallow(id, maxInlineDepth_);
  }

  bool isNamed(NodeId id) const { return graph_.isLeaf(id) || packs_.isStatement(id); }

  // True if the operands nest fewer than `levels` operations.
  bool areShallow(NodeId id, int levels) const {
    if (levels == 0) return false;
    for (int i = 0; i < graph_.arity(id); ++i) {
      const NodeId operand = graph_.operand(id, i);
      if (!isNamed(operand) && !(graph_.isOperation(operand) && areShallow(operand, levels - 1)))
        return false;
    }
    return true;
  }

  // True if a statement does nothing but assign these lanes to a result.
  bool assignsOnly(const Lanes& lanes, const Statement& statement) const {
    return statement.node == noNode &&
           std::equal(lanes.begin(), lanes.end(), statement.output->components.begin(),
                      statement.output->components.end());
  }

  // True for a pack that doesn't pay off because the packs it counted on were not made. Reading a
  // single lane costs a `.x`; packs and vectors that read all lanes save a `vec3( )`.
  bool isLoss(const Lanes& lanes) const {
    int gain = gainOf(lanes, packs_.chooseLayout(lanes, As::Statement).length);
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
          id != noNode && !output && !graph.isOurCall(id) && graph.type(id) == ops::Type::Float;
      if (id != noNode) packs.addStatement(id, canBePacked ? number : Packs::never);
      ++number;
    }
  }
  packs.measure(nodes);
  if (!options.vectors) return;
  number = 0;
  for (Statements& body : bodies) {
    const auto count = static_cast<std::uint32_t>(body.all.size());
    Packer(graph, packs, body, number, options).run();
    number += count;
  }
}

}  // namespace warpjet
