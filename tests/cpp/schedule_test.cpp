// The order in which nodes are computed. A good order keeps few values alive at a time, which can
// be measured from the order alone.
#include "graph/schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace warpjet {
namespace {

using Order = std::vector<std::uint32_t>;

class ScheduleTest : public testing::Test {
 protected:
  static constexpr bool result = true;

  Work work;

  std::uint32_t add(const Order& reads, bool isResult = false) {
    const auto first = static_cast<std::uint32_t>(work.reads.size());
    work.reads.insert(work.reads.end(), reads.begin(), reads.end());
    work.tasks.push_back({first, static_cast<std::uint32_t>(reads.size()), isResult});
    return static_cast<std::uint32_t>(work.tasks.size() - 1);
  }

  // Returns the max number of values that are alive between two statements.
  std::size_t maxAlive(const Order& order) const {
    std::vector<std::size_t> lastReader(order.size());
    for (std::size_t position = 0; position < order.size(); ++position) {
      for (const std::uint32_t read : work.readsOf(order[position])) lastReader[read] = position;
    }
    std::size_t max = 0;
    for (std::size_t position = 0; position < order.size(); ++position) {
      std::size_t alive = 0;
      for (std::size_t before = 0; before <= position; ++before)
        alive += work.tasks[order[before]].isResult || lastReader[order[before]] > position;
      max = std::max(max, alive);
    }
    return max;
  }

  Order sourceOrder() const {
    Order order(work.tasks.size());
    std::iota(order.begin(), order.end(), 0);
    return order;
  }
};

TEST_F(ScheduleTest, IsEmptyWithoutStatements) { EXPECT_EQ(schedule(work), Order{}); }

TEST_F(ScheduleTest, PutsLastUsesBeforeNewValues) {
  const auto a = add({}), b = add({}), endOfB = add({b}, result), endOfA = add({a}, result);
  EXPECT_EQ(schedule(work), (Order{a, endOfA, b, endOfB}));
}

// Two chains of nested sines: each angle is read by the next one, and every four angles by a
// product of derivatives. Neither chain is computed to its end before the other: then a processor
// would have to wait for each sine before it could start the next one.
TEST_F(ScheduleTest, InterleavesIndependentChains) {
  Order chains[2];
  for (Order& angles : chains) {
    Order slope;
    angles.push_back(add({}));
    for (int i = 1; i < 16; ++i) {
      const bool output = i == 15;
      angles.push_back(add({angles.back()}, output));
      slope.push_back(angles[i - 1]);
      if (i % 4 == 3) slope = {add(slope, output)};
    }
  }
  const Order order = schedule(work);
  const auto positionOf = [&](std::uint32_t i) {
    return std::find(order.begin(), order.end(), i) - order.begin();
  };
  for (int i = 4; i < 16; ++i) {
    EXPECT_LT(positionOf(chains[0][i - 4]), positionOf(chains[1][i])) << i;
    EXPECT_LT(positionOf(chains[1][i - 4]), positionOf(chains[0][i])) << i;
  }
  EXPECT_LE(maxAlive(order), 12u);
}

// Computes sum += sin(angle) and slope += cos(angle) in a loop. The source has all sums before all
// slopes.
TEST_F(ScheduleTest, KeepsOneAngleAliveForASumAndItsSlope) {
  Order angles;
  std::uint32_t sum = add({}), slope = add({});
  for (int i = 0; i < 100; ++i) {
    angles.push_back(add({}));
    sum = add({sum, angles.back()}, i == 99);
  }
  for (int i = 0; i < 100; ++i) slope = add({slope, angles[i]}, i == 99);
  EXPECT_GT(maxAlive(sourceOrder()), 100u);
  EXPECT_LE(maxAlive(schedule(work)), 4u);
}

TEST_F(ScheduleTest, OrdersEachStatementOnceAfterTheValuesItReads) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    work = {};
    for (std::uint32_t i = 0; i < 60; ++i) {
      Order reads;
      for (std::uint32_t k = 0; k < i && reads.size() < random() % 5; ++k) {
        const auto read = static_cast<std::uint32_t>(random() % i);
        if (std::find(reads.begin(), reads.end(), read) == reads.end()) reads.push_back(read);
      }
      add(reads, random() % 8 == 0);
    }
    const Order order = schedule(work);
    Order sorted = order;
    std::sort(sorted.begin(), sorted.end());
    ASSERT_EQ(sorted, sourceOrder());
    std::vector<bool> isWritten(order.size());
    for (const std::uint32_t i : order) {
      for (const std::uint32_t read : work.readsOf(i)) ASSERT_TRUE(isWritten[read]);
      isWritten[i] = true;
    }
  }
}

// Tasks share a list if their statements read the same values.
TEST_F(ScheduleTest, TasksMayShareAListOfReads) {
  const auto a = add({});
  const auto b = add({a}, result);
  work.tasks.push_back(work.tasks[b]);
  work.tasks.push_back(work.tasks[b]);
  EXPECT_EQ(schedule(work), (Order{a, b, b + 1, b + 2}));
  const Readers readers(work);
  const auto readersOfA = readers.of(a);
  EXPECT_EQ(Order(readersOfA.begin(), readersOfA.end()), (Order{b, b + 1, b + 2}));
}

TEST_F(ScheduleTest, HandlesAHundredThousandStatements) {
  std::uint32_t last = add({});
  for (int i = 0; i < 100'000; ++i) last = add({0, last});
  EXPECT_EQ(schedule(work).size(), 100'001u);
}

}  // namespace
}  // namespace warpjet
