#include "eval/kinks.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace warpjet {

namespace {

constexpr std::array comparisons{ops::find("lt"), ops::find("le"), ops::find("gt"),
                                 ops::find("ge")};

class Kinks {
 public:
  Kinks(Graph& graph, std::span<const NodeId> nodes) : graph_(graph), users_(graph.size()) {
    for (const NodeId id : nodes) {
      for (int i = 0; i < graph.arity(id); ++i) users_[index(graph.operand(id, i))].push_back(id);
    }
  }

  void find(NodeId id) {
    if (!graph_.isOperation(id)) return;
    const Op op = graph_.node(id).op;
    const auto operand = [&](int i) { return graph_.operand(id, i); };
    if (op == ops::find("abs")) add(operand(0), graph_.constant(0));
    if (op == ops::find("max") || op == ops::find("min")) add(operand(0), operand(1));
    if (op == ops::find("clamp")) {
      add(operand(0), operand(1));
      add(operand(0), operand(2));
    }
    if (op == ops::find("ifElse")) addChoice(operand(0), operand(1), operand(2));
    if (op == ops::find("sqrt") && !isDivisor(id)) all_.push_back({operand(0), {Profile::Cusp}});
  }

  std::vector<FrontAt> all() && { return std::move(all_); }

 private:
  // Adds a kink where two numbers are equal.
  void add(NodeId x, NodeId y) {
    if (graph_.isConstant(x)) std::swap(x, y);
    if (graph_.isConstant(y))
      addAt(x, graph_.value(y));
    else
      addAt(graph_.apply(ops::find("sub"), {x, y}), 0);
  }

  // A sum of squares doesn't pass 0, for which vectors that are normalized are tested.
  void addAt(NodeId argument, double limit) {
    const Interval range = graph_.range(argument);
    if (range.low < limit && limit < range.high) all_.push_back({argument, {Profile::Kink, limit}});
  }

  // A choice between two constants is a jump, not a kink.
  void addChoice(NodeId condition, NodeId yes, NodeId no) {
    if (graph_.isConstant(yes) && graph_.isConstant(no)) return;
    if (std::any_of(comparisons.begin(), comparisons.end(),
                    [&](Op op) { return graph_.is(condition, op); }))
      add(graph_.operand(condition, 0), graph_.operand(condition, 1));
  }

  // Tests whether whatever reads a length divides by it.
  bool isDivisor(NodeId id) const {
    const std::vector<NodeId>& users = users_[index(id)];
    return !users.empty() && std::all_of(users.begin(), users.end(), [&](NodeId user) {
      return graph_.is(user, ops::find("div")) && graph_.operand(user, 1) == id;
    });
  }

  Graph& graph_;
  std::vector<std::vector<NodeId>> users_;
  std::vector<FrontAt> all_;
};

}  // namespace

std::vector<FrontAt> kinksOf(Graph& graph, std::span<const NodeId> nodes) {
  Kinks kinks(graph, nodes);
  for (const NodeId id : nodes) kinks.find(id);
  return std::move(kinks).all();
}

}  // namespace warpjet
