#include "emit/products.hpp"

namespace warpjet {

namespace {

class Finder {
 public:
  Finder(const Graph& graph, std::span<const std::uint32_t> uses)
      : graph_(graph), uses_(uses), isMinus_(graph.size()) {}

  MatrixProducts run(std::span<const NodeId> nodes) {
    MatrixProducts products;
    products.terms.resize(graph_.size());
    for (const NodeId id : nodes) {
      if (!findSums(id) || !findEntries()) continue;
      products.all.push_back(product_);
      for (const NodeId term : terms_) products.terms[index(term)] = true;
    }
    return products;
  }

 private:
  // Matches the inverse length of a vector. The components of the vector become the sums of the
  // product.
  bool findSums(NodeId inverse) {
    if (!graph_.is(inverse, inversesqrt)) return false;
    NodeId rest = graph_.operand(inverse, 0);
    for (int column = 2; column >= 0; --column) {
      if (column > 0 && !graph_.is(rest, add)) return false;
      const NodeId square = column > 0 ? graph_.operand(rest, 1) : rest;
      if (!graph_.is(square, mult) || graph_.operand(square, 0) != graph_.operand(square, 1))
        return false;
      product_.sums[column] = graph_.operand(square, 0);
      rest = graph_.operand(rest, 0);
    }
    return true;
  }

  // Finds the entries of the product in its sums. Breadth-first, so that each term follows the sum
  // that it belongs to.
  bool findEntries() {
    product_.vector = none;
    terms_.clear();
    found_ = differences_ = 0;
    for (unsigned column = 0; column < 3; ++column) {
      const std::size_t first = terms_.size();
      terms_.push_back(product_.sums[column]);
      isMinus_[index(product_.sums[column])] = false;
      for (std::size_t next = first; next < terms_.size(); ++next) {
        const NodeId id = terms_[next];
        if (next != first && uses_[index(id)] > 1) return false;
        const bool isSum = graph_.is(id, add), isDifference = graph_.is(id, sub);
        if (!isSum && !isDifference && !graph_.is(id, neg)) {
          if (!addEntry(column, id)) return false;
          continue;
        }
        for (int i = 0; i < graph_.arity(id); ++i) {
          const NodeId term = graph_.operand(id, i);
          const bool isNegated = isDifference ? i == 1 : !isSum;
          isMinus_[index(term)] = isMinus_[index(id)] != isNegated;
          terms_.push_back(term);
        }
      }
    }
    return found_ == (1U << 9) - 1 && differences_ < 9;
  }

  // Adds a term if it is a component of the vector times a factor, in either order.
  bool addEntry(unsigned column, NodeId term) {
    for (int i = 0; graph_.is(term, mult) && i < 2; ++i) {
      const NodeId component = graph_.operand(term, i), factor = graph_.operand(term, 1 - i);
      const auto [vector, row, unused] = graph_.node(component).operands;
      if (!graph_.isInput(component) || graph_.input(vector).shape != vectorOf(3)) continue;
      if (product_.vector == none) product_.vector = vector;
      const unsigned place = 3 * column + row;
      if (vector != product_.vector || (found_ >> place & 1) != 0) continue;
      found_ |= 1U << place;
      differences_ += graph_.is(factor, sub);
      product_.entries[place] = {factor, isMinus_[index(term)] != 0};
      return true;
    }
    return false;
  }

  static constexpr Op add = ops::find("add"), sub = ops::find("sub"), mult = ops::find("mult"),
                      neg = ops::find("neg"), inversesqrt = ops::find("inversesqrt");

  const Graph& graph_;
  std::span<const std::uint32_t> uses_;
  Flags isMinus_;  // by node, for terms
  // The candidate product; of it, `found_` has a bit for each entry that was found, and
  // `differences_` is the number of entries whose factors are differences.
  MatrixProduct product_{};
  std::vector<NodeId> terms_;
  unsigned found_ = 0, differences_ = 0;
};

}  // namespace

MatrixProducts findProducts(const Graph& graph, std::span<const NodeId> nodes,
                            std::span<const std::uint32_t> uses) {
  return Finder(graph, uses).run(nodes);
}

}  // namespace warpjet
