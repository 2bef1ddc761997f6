// The tables that compute passes read: the topology of a base mesh, and all tessellations.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <set>
#include <vector>

#include "detail/tessellation_table.hpp"
#include "detail/topology.hpp"

namespace warpjet {
namespace {

using Words = std::vector<std::uint32_t>;

// Two triangles of a square that share no vertices: each has its own side along the diagonal.
TEST(ComputeTables, TopologyListsCornersSidesAndEdges) {
  const BaseMesh base({{3, false, {0, 0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0}}},
                      {{0, 1, 2}, {3, 4, 5}});
  const Words words = topologyOf(base);
  // Sides 0 to 5 in the order of the triangles. Side 2 goes back to corner 0. Side 5 goes from
  // corner 5, whose place is that of vertex 0, to corner 3.
  const Words triangles{0, 1, 2, 1, 3, 4, 3, 4, 5, 7, 8, 11};
  const Words sides{0, 1, 0, 1, 2, 1, 0, 2, 2, 3, 4, 3, 5, 4, 4, 5, 3, 2};
  Words expected = triangles;
  expected.insert(expected.end(), sides.begin(), sides.end());
  EXPECT_EQ(words, expected);
}

TEST(ComputeTables, TessellationsAreInAscendingOrder) {
  TessellationTable table;
  // The first tessellations have 1, 1 and each number of pieces on their sides, the next one 1, 2
  // and 1.
  for (std::size_t i = 0; i <= pieceCounts.size(); ++i) EXPECT_TRUE(table.makeNext());
  const Words& words = table.words();
  for (std::size_t i = 0; i < pieceCounts.size(); ++i) {
    // The tessellation is a fan, without inner points.
    EXPECT_EQ(words[2 * i + 1], pieceCounts[i]);
  }
  // One triangle, whose corners are the points 0, 1 and 2 in some order.
  const std::uint32_t packed = words[words[0]];
  EXPECT_EQ((std::set{packed & 1023, packed >> 10 & 1023, packed >> 20}),
            (std::set<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(words[2 * pieceCounts.size() + 1], 2u);
}

// Makes all tessellations up to number `last`.
TessellationTable tableUpTo(int last) {
  TessellationTable table;
  for (int i = 0; i <= last; ++i) table.makeNext();
  return table;
}

// The tessellation with 4, 4 and 4 pieces on its sides is number 549, counted from 0. It has 16
// equal triangles with three inner points, whose weights are 1/4, 1/4 and 1/2.
TEST(ComputeTables, TessellationsHaveTheirWeights) {
  const TessellationTable table = tableUpTo(549);
  const Words& words = table.words();
  const std::uint32_t first = words[1098], counts = words[1099];
  EXPECT_EQ(counts, 3u << 21 | 16u);
  ASSERT_EQ(words.size(), first + 9 + 16);
  std::multiset<float> weights;
  for (std::uint32_t i = 0; i < 9; ++i) {
    float weight = 0;
    std::memcpy(&weight, &words[first + i], sizeof weight);
    weights.insert(std::round(weight * 1e6f) / 1e6f);
  }
  EXPECT_EQ(weights.count(0.25f), 6u);
  EXPECT_EQ(weights.count(0.5f), 3u);
}

// The tessellation with 3, 3 and 1 pieces is number 364. It has two quadrilaterals between the long
// sides, whose diagonals can be flipped, and the triangle at the corner between them.
TEST(ComputeTables, TessellationsHaveTheirFlips) {
  const TessellationTable table = tableUpTo(364);
  const Words& words = table.words();
  const std::uint32_t first = words[728], counts = words[729];
  EXPECT_EQ(counts, 2u << 11 | 5u);
  ASSERT_EQ(words.size(), first + 5 + 2 * 3);
  std::set<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < 2; ++i) corners.insert(words[first + 4] >> 10 * i & 0x3ff);
  corners.insert(words[first + 4] >> 20);
  EXPECT_EQ(corners, (std::set<std::uint32_t>{2, 3, 4}));
}

}  // namespace
}  // namespace warpjet
