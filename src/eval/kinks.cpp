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
  Kinks(Graph& graph, std::span<const NodeId> nodes, std::span<const NodeId> roots)
      : graph_(graph), users_(graph.size()), isRoot_(graph.size()) {
    for (const NodeId id : nodes) {
      for (int i = 0; i < graph.arity(id); ++i) users_[index(graph.operand(id, i))].push_back(id);
    }
    for (const NodeId root : roots) isRoot_[index(root)] = true;
  }

  void addKinksOf(NodeId id) {
    if (!graph_.isOperation(id)) return;
    const Op op = graph_.node(id).op;
    const auto operand = [&](int i) { return graph_.operand(id, i); };
    if (op == ops::find("abs")) addWhereEqual(operand(0), graph_.constant(0));
    if (op == ops::find("max") || op == ops::find("min")) addWhereEqual(operand(0), operand(1));
    if (op == ops::find("clamp")) {
      addWhereEqual(operand(0), operand(1));
      addWhereEqual(operand(0), operand(2));
    }
    if (op == ops::find("ifElse")) addChoice(operand(0), operand(1), operand(2));
    if (op == ops::find("sqrt") && !isDivisor(id)) addCusp(operand(0));
  }

  std::vector<FrontAt> all() && { return std::move(all_); }

 private:
  void addWhereEqual(NodeId x, NodeId y) {
    if (graph_.isConstant(x)) std::swap(x, y);
    if (graph_.isConstant(y))
      addAtLimit(x, graph_.value(y));
    else
      addAtLimit(graph_.apply(ops::find("sub"), {x, y}), 0);
  }

  // The argument must pass the limit: x * x + y * y > 0, the test before a vector is normalized,
  // never does.
  void addAtLimit(NodeId argument, double limit) {
    const Interval range = graph_.range(argument);
    if (range.low < limit && limit < range.high) all_.push_back({argument, {Profile::Kink, limit}});
  }

  // sqrt(1 + x * x) has no cusp.
  void addCusp(NodeId argument) {
    if (graph_.range(argument).low <= 0) all_.push_back({argument, {Profile::Cusp}});
  }

  // A choice between two constants is a jump, not a kink.
  void addChoice(NodeId condition, NodeId yes, NodeId no) {
    if (graph_.isConstant(yes) && graph_.isConstant(no)) return;
    if (std::any_of(comparisons.begin(), comparisons.end(),
                    [&](Op op) { return graph_.is(condition, op); }))
      addWhereEqual(graph_.operand(condition, 0), graph_.operand(condition, 1));
  }

  // Tests whether a node is used only as a divisor, as a length by which a vector is normalized.
  bool isDivisor(NodeId id) const {
    const std::vector<NodeId>& users = users_[index(id)];
    return !users.empty() && !isRoot_[index(id)] &&
           std::all_of(users.begin(), users.end(), [&](NodeId user) {
             return graph_.is(user, ops::find("div")) && graph_.operand(user, 1) == id;
           });
  }

  Graph& graph_;
  std::vector<std::vector<NodeId>> users_;
  std::vector<bool> isRoot_;
  std::vector<FrontAt> all_;
};

}  // namespace

std::vector<FrontAt> kinksOf(Graph& graph, std::span<const NodeId> nodes,
                             std::span<const NodeId> roots) {
  Kinks kinks(graph, nodes, roots);
  for (const NodeId id : nodes) kinks.addKinksOf(id);
  return std::move(kinks).all();
}

}  // namespace warpjet
