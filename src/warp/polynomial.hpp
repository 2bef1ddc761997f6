// A number as a polynomial of other nodes, in which what cancels is gone and common factors are
// seen: (c - 1) + (u - 1) * c + 1 is u c.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

// A node that is no sum, product or quotient for the polynomial, or 1 divided by one.
struct Atom {
  NodeId node;
  bool isInverse = false;

  bool operator==(const Atom&) const = default;
};

// A product of atoms, by number and in order; one that counts twice is there twice.
struct Monomial {
  static constexpr std::size_t maxFactors = 12;
  static constexpr std::uint8_t none = 0xff;

  double coefficient = 1;
  std::array<std::uint8_t, maxFactors> factors = filled();

  static constexpr std::array<std::uint8_t, maxFactors> filled() {
    std::array<std::uint8_t, maxFactors> all{};
    all.fill(none);
    return all;
  }
};

// In the order of their factors, each once.
using Polynomial = std::vector<Monomial>;

// Writes nodes as polynomials, unless that would take long. The sum
// of the squares of a sine and its cosine is 1.
class Expansion {
 public:
  explicit Expansion(const Graph& graph) : graph_(graph) {}

  // Empty if the expansion would take long.
  std::optional<Polynomial> of(NodeId id) {
    const Polynomial& terms = expand(id, maxLevels);
    return isTooLong_ ? std::nullopt : std::optional(terms);
  }
  // Indexed by the factors of monomials.
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
  // The number of terms that may still be made. A mirror, twisted about an oblique axis, takes 700;
  // most warps that can have either sign are given up before.
  std::size_t left_ = 1500;
  bool isTooLong_ = false;
};

}  // namespace warpjet
