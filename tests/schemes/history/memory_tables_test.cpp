// SPDX-License-Identifier: MIT
// The eight exponentials that replace all slow ones within a block.

#include "fdebench/schemes/history/memory_tables.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fde::bench {
namespace {

using Real = long double;

constexpr Real table_unit = std::numeric_limits<double>::epsilon() / 2;

MemoryTables tables_of(double order, double steps) {
  return {{{&families::rectangle, order}, {&families::trapezoid, order}},
          exponential_sum(order, MemoryTables::recent - 1, steps + 2.0, 1e-15)};
}

// Eight coefficients are rounded; the sum of their absolute values is below three.
TEST(MemoryTables, PointsStandForEverySlowExponentialAtEveryLagOfABlock) {
  for (const double order : {0.05, 0.5, 0.95}) {
    const MemoryTables tables = tables_of(order, 1e8);
    ASSERT_GT(tables.slow, 2 * lanes);
    for (Eigen::Index m = tables.nodes.size() - tables.exponentials; m < tables.slow; ++m) {
      for (int t = 0; t <= MemoryTables::recent + MemoryTables::block; ++t) {
        Real sum = 0;
        for (Eigen::Index i = 0; i < tables.points(); ++i)
          sum += tables.spread(m, i) * std::exp(-Real{tables.compressed.nodes[i]} * t);
        const Real exact = std::exp(-Real{tables.nodes[m]} * t);
        EXPECT_LE(std::abs(sum - exact), 3 * table_unit * exact) << "node " << m << ", t = " << t;
      }
    }
  }
}

TEST(MemoryTables, JoinNothingInShortRuns) {
  const MemoryTables tables = tables_of(0.5, 1000);
  EXPECT_EQ(tables.slow, 0);
  EXPECT_EQ(tables.points(), 0);
  EXPECT_EQ(tables.far.cols(), tables.nodes.size());
}

}  // namespace
}  // namespace fde::bench
