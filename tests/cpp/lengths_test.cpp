// Lengths, which are updated when a name changes, compared with lengths that are recomputed from
// their definition.
#include "emit/lengths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "support.hpp"

namespace warpjet {
namespace {

class LengthsTest : public testing::Test {
 protected:
  Graph graph;
  std::map<NodeId, int> names;

  int expectedWhereRead(NodeId id, int levels) const {
    if (const auto name = names.find(id); name != names.end()) return name->second;
    if (graph.isInput(id)) {
      const Input& input = graph.input(graph.node(id).operands[0]);
      const int label = std::min(static_cast<int>(input.label.size()), 12);
      return input.shape.isNumber() ? label : label + Lengths::member;
    }
    return levels == 0 ? Lengths::typicalNumber : expectedOperation(id, levels);
  }

  int expectedOperation(NodeId id, int levels) const {
    if (!graph.isOperation(id)) return Lengths::typicalNumber;
    auto total =
        static_cast<int>(ops::spelling(graph.node(id).op, ops::Language::Glsl300).text.size());
    for (int i = 0; i < graph.arity(id); ++i)
      total += expectedWhereRead(graph.operand(id, i), levels - 1) - Lengths::member;
    return total;
  }

  void expectAll(const Lengths& lengths, std::span<const NodeId> nodes) const {
    for (const NodeId id : nodes) {
      for (const int levels : {1, 2, 3, 7, Lengths::maxLevels}) {
        ASSERT_EQ(lengths.whereRead(id, levels), expectedWhereRead(id, levels)) << index(id);
        ASSERT_EQ(lengths.lengthOfOperation(id, levels), expectedOperation(id, levels))
            << index(id);
      }
    }
  }
};

TEST_F(LengthsTest, AreUpdatedWhenANameChanges) {
  std::mt19937 random(7);
  const auto below = [&](std::size_t count) { return random() % count; };
  const Value p = vector3(graph, "position"), q = vector3(graph, "aLongNameThatIsCut");
  const Expression s = scalar(graph, "time");
  std::vector<Expression> made{p[0], p[1], p[2], q[0], q[1], s};
  for (int i = 0; i < 400; ++i) {
    // Picks mostly recent nodes, so that expressions nest deeper than the measured levels.
    const auto pick = [&] { return made[made.size() - 1 - below(below(4) ? 3 : made.size())]; };
    const Expression x = pick(), y = pick();
    switch (below(5)) {
      case 0:
        made.push_back(sin(x));
        break;
      case 1:
        made.push_back(x + y * 3.5);
        break;
      case 2:
        made.push_back(ifElse(lt(x, y), x, 0.25));
        break;
      default:
        made.push_back(x * y);
    }
  }
  std::vector<NodeId> nodes, operations;
  for (std::uint32_t i = 0; i < graph.size(); ++i) {
    nodes.push_back(NodeId{i});
    if (graph.isOperation(nodes.back())) operations.push_back(nodes.back());
  }
  Lengths lengths(graph, ops::Language::Glsl300);
  for (const NodeId id : operations) {
    if (below(3) == 0) continue;
    names[id] = Lengths::name;
    lengths.setName(id, Lengths::name);
  }
  lengths.measure(nodes);
  expectAll(lengths, nodes);
  for (int i = 0; i < 300; ++i) {
    const NodeId id = operations[below(operations.size())];
    if (!names.contains(id)) continue;
    if (below(4) == 0) {
      names.erase(id);
      lengths.removeName(id);
    } else {
      names[id] = Lengths::name + (names[id] == Lengths::name ? Lengths::member : 0);
      lengths.setName(id, names[id]);
    }
    if (i % 20 == 0) expectAll(lengths, nodes);
  }
  expectAll(lengths, nodes);
}

TEST_F(LengthsTest, AreComputedWithoutRecursionForALongChain) {
  Expression x = scalar(graph, "x");
  std::vector<NodeId> nodes{x.id};
  for (int i = 0; i < 100'000; ++i) nodes.push_back((x = sin(x)).id);
  Lengths lengths(graph, ops::Language::Glsl300);
  lengths.setName(nodes[1], Lengths::name);
  lengths.measure(nodes);
  lengths.setName(nodes[1], Lengths::name + Lengths::member);
  EXPECT_EQ(lengths.lengthOfOperation(nodes[2], Lengths::maxLevels), 10);  // `sin(t12.x)`
  lengths.removeName(nodes[1]);
  EXPECT_EQ(lengths.lengthOfOperation(nodes[2], Lengths::maxLevels), 11);  // `sin(sin(x))`
}

}  // namespace
}  // namespace warpjet
