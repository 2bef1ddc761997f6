#include "emit/borders.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "emit/rewriter.hpp"
#include "emit/screen.hpp"
#include "graph/flags.hpp"

namespace warpjet {

namespace {

constexpr double infinity = Interval::infinity;

// The interval of the first operand in which an operation is defined.
struct Domain {
  Op op;
  double low, high;
};

// inversesqrt is not listed, since the derivatives of asin and acos contain it. An operand that
// would have to be reflected makes it NaN instead, and a NaN normal is replaced by the geometric
// normal.
constexpr Domain domains[] = {
    {ops::find("sqrt"), 0, infinity}, {ops::find("log"), 0, infinity},
    {ops::find("log2"), 0, infinity}, {ops::find("pow"), 0, infinity},
    {ops::find("asin"), -1, 1},       {ops::find("acos"), -1, 1},
    {ops::find("atanh"), -1, 1},      {ops::find("acosh"), 1, infinity},
};

// Moves a number away from the end of a domain by at least this part of a pixel, if it is reflected
// there: at the end itself slopes are infinite, or count as 0.
constexpr double minDistance = 1.0 / 16;

class Borders : public Rewriter {
 public:
  // Considers the operations of all results. The normal alone is not enough: that of log(x)
  // contains only the derivative 1 / x.
  Borders(Graph& graph, Library& library, Comments& comments)
      : Rewriter(graph, comments), library_(library), isInLoop_(graph.size()) {
    const auto size = static_cast<std::uint32_t>(graph.size());
    for (NodeId id{0}; index(id) < size; id = NodeId{index(id) + 1}) {
      isInLoop_[index(id)] = dependsOnStep(id);
      for (const auto& [op, low, high] : domains) {
        if (graph.is(id, op)) findEnds(graph.operand(id, 0), low, high);
      }
    }
  }

 private:
  // Returns true for values within a loop: their derivatives on the screen are undefined after
  // pixels have left the loop at different steps.
  bool dependsOnStep(NodeId id) const {
    if (graph_.isLocal(id)) return true;
    for (int i = 0; i < graph_.arity(id); ++i) {
      if (!graph_.isOutcome(id) && isInLoop_[index(graph_.operand(id, i))]) return true;
    }
    return false;
  }

  // Finds the number that has to be reflected for `id` to be between `low` and `high`. Constant
  // terms and factors are skipped: derivatives may have been simplified to read what is below them.
  void findEnds(NodeId id, double low, double high) {
    const Interval range = graph_.range(id);
    if (isInLoop_[index(id)] || (range.low >= low && range.high <= high)) return;
    const auto isConstantAt = [&](int i) { return graph_.isConstant(graph_.operand(id, i)); };
    const auto valueAt = [&](int i) { return graph_.value(graph_.operand(id, i)); };
    if (graph_.is(id, ops::find("neg"))) return findEnds(graph_.operand(id, 0), -high, -low);
    if (graph_.is(id, ops::find("sub")) && isConstantAt(0))
      return findEnds(graph_.operand(id, 1), valueAt(0) - high, valueAt(0) - low);
    if (graph_.is(id, ops::find("sub")) && isConstantAt(1))
      return findEnds(graph_.operand(id, 0), low + valueAt(1), high + valueAt(1));
    for (const int i : {0, 1}) {
      if (graph_.is(id, ops::find("add")) && isConstantAt(i))
        return findEnds(graph_.operand(id, 1 - i), low - valueAt(i), high - valueAt(i));
      if (graph_.is(id, ops::find("mult")) && isConstantAt(i) && valueAt(i) != 0) {
        const auto [first, last] = std::minmax({low / valueAt(i), high / valueAt(i)});
        return findEnds(graph_.operand(id, 1 - i), first, last);
      }
    }
    auto& found = ends_[id];
    for (const End& end : {End{low, 1}, End{high, -1}}) {
      const bool isKnown = std::find(found.begin(), found.end(), end) != found.end();
      if (std::abs(end.position) != infinity && !isKnown) found.push_back(end);
    }
  }

  NodeId replace(NodeId id) override {
    Expression x{&graph_, Rewriter::replace(id)};
    const auto found = ends_.find(id);
    if (found == ends_.end()) return x.id;
    const Expression pixel =
        abs(changeOnScreen(library_, acrossName, x)) + abs(changeOnScreen(library_, downName, x));
    for (const auto& [position, inward] : found->second) {
      const Expression excess = (position - x) * inward;
      const Expression isReflected = logicalAnd(le(0.0, excess), lt(excess, pixel));
      x = ifElse(isReflected, position + max(excess, pixel * minDistance) * inward, x);
    }
    return x.id;
  }

  // An end of a domain; `inward` is 1 if the domain is above it and -1 if it is below.
  struct End {
    double position, inward;
    bool operator==(const End&) const = default;
  };

  Library& library_;
  Flags isInLoop_;
  std::unordered_map<NodeId, std::vector<End>> ends_;
};

}  // namespace

bool hasBorders(const Graph& graph) {
  return std::any_of(std::begin(domains), std::end(domains),
                     [&](const Domain& domain) { return graph.has(domain.op); });
}

std::vector<NodeId> reflectAtBorders(Graph& graph, Library& library, std::span<const NodeId> roots,
                                     Comments& comments) {
  if (!hasBorders(graph)) return {roots.begin(), roots.end()};
  return Borders(graph, library, comments).rewrite(roots);
}

}  // namespace warpjet
