#include "warp/polynomial.hpp"

#include <algorithm>
#include <cmath>

namespace warpjet {

namespace {

constexpr Op neg = ops::find("neg"), add = ops::find("add"), sub = ops::find("sub"),
             mult = ops::find("mult"), divide = ops::find("div"), sine = ops::find("sin"),
             cosine = ops::find("cos");

// A sum that is smaller than this share of its terms is a rounding error of zero.
constexpr double rounding = 1e-13;

bool isBefore(const Monomial& x, const Monomial& y) { return x.factors < y.factors; }

// Sorts the terms and merges equal ones.
void collect(Polynomial& terms) {
  std::sort(terms.begin(), terms.end(), isBefore);
  std::size_t count = 0;
  for (std::size_t i = 0; i < terms.size();) {
    Monomial total = terms[i];
    double size = std::abs(total.coefficient);
    for (++i; i < terms.size() && terms[i].factors == total.factors; ++i) {
      total.coefficient += terms[i].coefficient;
      size += std::abs(terms[i].coefficient);
    }
    if (std::abs(total.coefficient) > rounding * size) terms[count++] = total;
  }
  terms.resize(count);
}

// Returns the product; nullopt if it has too many factors.
std::optional<Monomial> product(const Monomial& x, const Monomial& y) {
  std::array<std::uint8_t, 2 * Monomial::maxFactors> all;
  std::merge(x.factors.begin(), x.factors.end(), y.factors.begin(), y.factors.end(), all.begin());
  if (all[Monomial::maxFactors] != Monomial::none) return {};
  Monomial result{x.coefficient * y.coefficient};
  std::copy_n(all.begin(), Monomial::maxFactors, result.factors.begin());
  return result;
}

}  // namespace

const Polynomial& Expansion::expand(NodeId id, int levels) {
  if (const auto found = known_.find(id); found != known_.end()) return found->second;
  isTooLong_ |= termsLeft_ == 0;
  if (!isTooLong_) --termsLeft_;
  std::optional<Polynomial> terms;
  if (levels > 0 && !isTooLong_) terms = expanded(id, levels);
  if (!terms) terms = atom({id});
  isTooLong_ |= !terms;
  return known_.emplace(id, terms.value_or(Polynomial{})).first->second;
}

std::optional<Polynomial> Expansion::expanded(NodeId id, int levels) {
  if (graph_.isConstant(id)) {
    const double value = graph_.value(id);
    return value == 0 ? Polynomial{} : Polynomial{Monomial{value}};
  }
  const Op op = graph_.node(id).op;
  if (op != neg && op != add && op != sub && op != mult && op != divide) return {};
  const Polynomial& x = expand(graph_.operand(id, 0), levels - 1);
  if (op == neg) return sum({}, x, -1);
  const NodeId other = graph_.operand(id, 1);
  if (op == divide) {
    const auto inverse = atom({other, true});
    return inverse ? product(x, *inverse) : std::nullopt;
  }
  const Polynomial& y = expand(other, levels - 1);
  return op == mult ? product(x, y) : sum(x, y, op == sub ? -1 : 1);
}

std::optional<Polynomial> Expansion::sum(const Polynomial& x, const Polynomial& y, double sign) {
  Polynomial terms = x;
  for (Monomial term : y) {
    term.coefficient *= sign;
    terms.push_back(term);
  }
  collect(terms);
  isTooLong_ |= terms.size() > maxTerms;
  return terms;
}

std::optional<Polynomial> Expansion::product(const Polynomial& x, const Polynomial& y) {
  const std::size_t work = x.size() * y.size();
  isTooLong_ |= work > termsLeft_;
  if (isTooLong_) return {};
  termsLeft_ -= work;
  Polynomial terms;
  for (const Monomial& a : x) {
    for (const Monomial& b : y) {
      const auto term = warpjet::product(a, b);
      isTooLong_ |= !term;
      if (!term) return {};
      terms.push_back(*term);
    }
  }
  for (std::size_t i = 0; i < terms.size(); ++i)
    while (replaceSquaredSine(terms, i)) continue;
  collect(terms);
  isTooLong_ |= terms.size() > maxTerms;
  return terms;
}

// Replaces sin² by 1 - cos².
bool Expansion::replaceSquaredSine(Polynomial& terms, std::size_t i) {
  auto& factors = terms[i].factors;
  for (std::size_t k = 0; k + 1 < factors.size() && factors[k + 1] != Monomial::none; ++k) {
    if (factors[k] != factors[k + 1]) continue;
    const auto [node, isInverse] = atoms_[factors[k]];
    if (isInverse || !graph_.is(node, sine)) continue;
    const auto found = graph_.findNode(cosine, graph_.operand(node, 0), NodeId{0});
    const auto other = found ? atom({*found}) : std::nullopt;
    if (!other) continue;
    std::copy(factors.begin() + k + 2, factors.end(), factors.begin() + k);
    factors[factors.size() - 2] = factors[factors.size() - 1] = Monomial::none;
    // There is space for two cosines, since two sines were removed.
    const Monomial& factor = other->front();
    Monomial squared = *warpjet::product(*warpjet::product(terms[i], factor), factor);
    squared.coefficient = -squared.coefficient;
    terms.push_back(squared);
    return true;
  }
  return false;
}

std::optional<Polynomial> Expansion::atom(Atom wanted) {
  const auto found = std::find(atoms_.begin(), atoms_.end(), wanted);
  const auto number = static_cast<std::size_t>(found - atoms_.begin());
  if (number >= Monomial::none) return {};
  if (found == atoms_.end()) atoms_.push_back(wanted);
  Monomial term;
  term.factors[0] = static_cast<std::uint8_t>(number);
  return Polynomial{term};
}

}  // namespace warpjet
