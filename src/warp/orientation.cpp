#include "warp/orientation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "graph/flags.hpp"
#include "graph/reachable.hpp"
#include "warp/polynomial.hpp"

namespace warpjet {

namespace {

// Returns -1 or 1; nullopt if the sign is unknown. Zero counts as positive.
std::optional<double> signOf(const Interval& range) {
  if (range.low >= 0) return 1;
  return range.high <= 0 ? std::optional<double>(-1) : std::nullopt;
}

// Marks the nodes that x is computed from and that are equal for all vertices.
Flags uniformNodes(Expression x, std::span<const NodeId> vertexInputs) {
  const Graph& graph = *x.graph;
  Flags isUniform(graph.size());
  for (const NodeId id : reachable(graph, std::array{x.id})) {
    // A host function may read anything.
    bool isSame = !graph.isCall(id) || graph.isLibraryCall(id);
    // The CPU also computes the sign, and it can't read images.
    if (graph.isInput(id))
      isSame = graph.input(graph.node(id).operands[0]).shape != imageShape &&
               std::find(vertexInputs.begin(), vertexInputs.end(), id) == vertexInputs.end();
    for (int i = 0; i < graph.arity(id); ++i) isSame &= isUniform[index(graph.operand(id, i))] != 0;
    isUniform[index(id)] = isSame;
  }
  return isUniform;
}

// A product of numbers that are equal for all vertices, times 1 or -1.
struct Sign {
  double known = 1;
  std::vector<Expression> factors = {};
};

// Finds the sign of a polynomial that is the product of a uniform factor and a factor that never
// changes its sign.
class SignOfPolynomial {
 public:
  SignOfPolynomial(Graph& graph, const std::vector<Atom>& atoms, const Flags& isUniform)
      : graph_(graph), atoms_(atoms), isUniform_(isUniform) {}

  std::optional<double> known(const Polynomial& terms) {
    // If the sign is unknown for inputs of moderate magnitude, it is unknown for all.
    if (!signOf(rangeOf(terms, [&](NodeId id) { return graph_.range(id); }))) return {};
    if (ranges_.empty()) ranges_ = graph_.rangesOfAll();
    return signOf(rangeOf(terms, [&](NodeId id) { return ranges_[index(id)]; }));
  }

  std::optional<Sign> of(Polynomial terms) {
    const std::vector<std::uint8_t> common = takeCommonFactors(terms);
    // Maps each product of varying atoms to its uniform coefficient.
    std::vector<std::pair<Monomial, Polynomial>> parts;
    for (const Monomial& each : terms) {
      const auto halves = split(each);
      const auto part = std::find_if(parts.begin(), parts.end(), [&](const auto& other) {
        return other.first.factors == halves.first.factors;
      });
      if (part == parts.end())
        parts.push_back({halves.first, {halves.second}});
      else
        part->second.push_back(halves.second);
    }
    Polynomial rest;
    for (auto& [varying, uniform] : parts) {
      std::sort(uniform.begin(), uniform.end(), isBefore);
      const auto ratio = ratioOf(uniform, parts.front().second);
      if (!ratio) return {};
      varying.coefficient = *ratio;
      rest.push_back(varying);
    }
    const auto knownSign = known(rest);
    if (!knownSign) return {};
    Sign sign{*knownSign};
    multiply(sign, parts.front().second);
    for (const std::uint8_t factor : common) multiply(sign, {term(factor)});
    return sign;
  }

 private:
  static Monomial term(std::uint8_t factor) {
    Monomial made;
    made.factors[0] = factor;
    return made;
  }

  static bool isBefore(const Monomial& x, const Monomial& y) { return x.factors < y.factors; }

  // Returns true if an atom is equal for all vertices. That includes a cosine of a uniform angle
  // which `uniformNodes` has not marked, since `replaceSquaredSine` finds it in the graph.
  bool isUniform(std::uint8_t factor) const {
    const NodeId node = atoms_[factor].node;
    return isUniform_[index(node)] ||
           (graph_.is(node, ops::find("cos")) && isUniform_[index(graph_.operand(node, 0))]);
  }

  // Removes the uniform factors that all terms have in common; returns those that occur an odd
  // number of times.
  std::vector<std::uint8_t> takeCommonFactors(Polynomial& terms) const {
    std::vector<std::uint8_t> common;
    for (std::size_t k = 0; k < Monomial::maxFactors;) {
      const std::uint8_t factor = terms.front().factors[k];
      if (factor == Monomial::none) break;
      const bool isCommon =
          isUniform(factor) && std::all_of(terms.begin(), terms.end(), [&](const Monomial& each) {
            return std::find(each.factors.begin(), each.factors.end(), factor) !=
                   each.factors.end();
          });
      if (!isCommon) {
        ++k;
        continue;
      }
      if (!common.empty() && common.back() == factor)
        common.pop_back();
      else
        common.push_back(factor);
      for (Monomial& each : terms) {
        const auto found = std::find(each.factors.begin(), each.factors.end(), factor);
        std::copy(found + 1, each.factors.end(), found);
        each.factors.back() = Monomial::none;
      }
    }
    return common;
  }

  // Splits a term into its varying atoms, and its uniform atoms with the coefficient.
  std::pair<Monomial, Monomial> split(const Monomial& each) const {
    Monomial varying, uniform{each.coefficient};
    std::size_t v = 0, u = 0;
    for (const std::uint8_t factor : each.factors) {
      if (factor == Monomial::none) break;
      if (isUniform(factor))
        uniform.factors[u++] = factor;
      else
        varying.factors[v++] = factor;
    }
    return {varying, uniform};
  }

  // Returns the number r with x = r y, if there is one. The terms of x and y must be sorted.
  static std::optional<double> ratioOf(const Polynomial& x, const Polynomial& y) {
    constexpr double tolerance = 1e-9;
    if (x.size() != y.size()) return {};
    const double ratio = x.front().coefficient / y.front().coefficient;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double expected = ratio * y[i].coefficient;
      if (x[i].factors != y[i].factors ||
          std::abs(x[i].coefficient - expected) > tolerance * std::abs(expected))
        return {};
    }
    return ratio;
  }

  template <class Range>
  Interval rangeOf(const Polynomial& terms, Range rangeOfNode) const {
    Interval total = 0.0;
    for (const Monomial& each : terms) {
      Interval product = each.coefficient;
      for (std::size_t k = 0; k < Monomial::maxFactors && each.factors[k] != Monomial::none; ++k) {
        const auto [node, isInverse] = atoms_[each.factors[k]];
        const Interval range = rangeOfNode(node);
        const bool isSquare =
            k + 1 < Monomial::maxFactors && each.factors[k + 1] == each.factors[k];
        const Interval factor = isSquare ? square(range) : range;
        product = isInverse ? product / factor : product * factor;
        k += isSquare;
      }
      total = total + product;
    }
    return total;
  }

  void multiply(Sign& sign, const Polynomial& terms) {
    if (const auto knownSign = known(terms))
      sign.known *= *knownSign;
    else
      sign.factors.push_back(nodeOf(terms));
  }

  // Returns a node with the sign of the sum of the terms. In a single term, a factor's inverse is
  // replaced by the factor, which has the same sign.
  Expression nodeOf(const Polynomial& terms) {
    Expression total{&graph_, graph_.constant(0)};
    for (const Monomial& each : terms) {
      Expression product{&graph_, graph_.constant(each.coefficient)};
      for (const std::uint8_t factor : each.factors) {
        if (factor == Monomial::none) break;
        const Expression x{&graph_, atoms_[factor].node};
        const bool isAlone = terms.size() == 1;
        product = atoms_[factor].isInverse && !isAlone ? product / x : product * x;
      }
      total = total + product;
    }
    return total;
  }

  Graph& graph_;
  const std::vector<Atom>& atoms_;
  const Flags& isUniform_;
  std::vector<Interval> ranges_;  // computed on demand
};

std::optional<Sign> signOf(Expression x, std::span<const NodeId> vertexInputs) {
  Graph& graph = *x.graph;
  if (graph.isConstant(x.id)) return Sign{graph.value(x.id) < 0 ? -1.0 : 1.0};
  if (signOf(graph.range(x.id))) {
    if (const auto known = signOf(graph.rangesOfAll()[index(x.id)])) return Sign{*known};
  }
  const Flags isUniform = uniformNodes(x, vertexInputs);
  Expansion expansion(graph);
  const auto terms = expansion.of(x.id);
  if (terms && terms->empty()) return Sign{};
  const bool isAllUniform = isUniform[index(x.id)];
  if (terms) {
    SignOfPolynomial sign(graph, expansion.atoms(), isUniform);
    if (!isAllUniform || terms->size() == 1) return sign.of(*terms);
    if (const auto known = sign.known(*terms)) return Sign{*known};
  }
  return isAllUniform ? std::optional(Sign{1, {x}}) : std::nullopt;
}

}  // namespace

std::optional<Expression> orientation(Expression determinant,
                                      std::span<const NodeId> vertexInputs) {
  Graph& graph = *determinant.graph;
  const auto sign = signOf(determinant, vertexInputs);
  if (!sign) return {};
  const Expression known{&graph, graph.constant(sign->known)};
  if (sign->factors.empty()) return known;
  Expression product = sign->factors.front();
  for (std::size_t i = 1; i < sign->factors.size(); ++i) product = product * sign->factors[i];
  return ifElse(lt(product, 0.0), -known, known);
}

}  // namespace warpjet
