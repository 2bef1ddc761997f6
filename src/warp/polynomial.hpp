// Expands a node to a polynomial of other nodes, which cancels terms and reveals common factors: (c
// - 1) + (u - 1) * c + 1 is u c.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

// A node that the polynomial doesn't expand, as it isn't a sum, product or quotient; or its
// inverse.
struct Atom {
  NodeId node;
  bool isInverse = false;

  bool operator==(const Atom&) const = default;
};

// A coefficient times a product of atoms: the factors are the numbers of the atoms, sorted; the
// atom of a square is listed twice.
struct Monomial {
  static constexpr std::size_t maxFactors = 12;
  static constexpr std::uint8_t none = 0xff;

  double coefficient = 1;
  std::array<std::uint8_t, maxFactors> factors = emptyFactors();

  static constexpr std::array<std::uint8_t, maxFactors> emptyFactors() {
    std::array<std::uint8_t, maxFactors> all{};
    all.fill(none);
    return all;
  }
};

// The terms, sorted by their factors, without duplicates.
using Polynomial = std::vector<Monomial>;

// Expands nodes to polynomials, up to a limit. Knows that the squares of sine and cosine add up
// to 1.
class Expansion {
 public:
  explicit Expansion(const Graph& graph) : graph_(graph) {}

  // Returns the polynomial of a node; nullopt if the expansion exceeds the limit.
  std::optional<Polynomial> of(NodeId id) {
    const Polynomial& terms = expand(id, maxLevels);
    return isTooLong_ ? std::nullopt : std::optional(terms);
  }
  // Returns the atoms, which the factors of monomials number.
  const std::vector<Atom>& atoms() const { return atoms_; }

 private:
  static constexpr int maxLevels = 24;
  static constexpr std::size_t maxTerms = 64;

  const Polynomial& expand(NodeId id, int levels);
  std::optional<Polynomial> expanded(NodeId id, int levels);
  std::optional<Polynomial> sum(const Polynomial& x, const Polynomial& y, double sign);
  std::optional<Polynomial> product(const Polynomial& x, const Polynomial& y);
  std::optional<Polynomial> atom(Atom wanted);
  bool replaceSquaredSine(Polynomial& terms, std::size_t i);

  const Graph& graph_;
  std::vector<Atom> atoms_;
  std::map<NodeId, Polynomial> known_;
  // The number of terms that may still be created. A mirror that is twisted about an oblique axis
  // takes 700 terms; for most warps whose determinant can have either sign, the expansion exceeds
  // the limit.
  std::size_t termsLeft_ = 1500;
  bool isTooLong_ = false;
};

}  // namespace warpjet
