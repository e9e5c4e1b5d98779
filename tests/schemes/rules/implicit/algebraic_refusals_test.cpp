// SPDX-License-Identifier: MIT
// Algebraic rows 0 = f_i(t, y): which schemes and functions refuse them, and which leave them unchanged.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fdebench/schemes/problem/smoothness.hpp"
#include "fdebench/schemes/stepping/order_splitting.hpp"
#include "support/algebraic_problems.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

TEST(AlgebraicRefusals, ExplicitSchemesRefuseWithTheReason) {
  int refused = 0;
  for (const Scheme& scheme : schemes()) {
    if (scheme.capabilities.implicit || scheme.capabilities.discretises_equations) continue;
    ++refused;
    Resolution resolution = Grid{2.0, 8};
    if (scheme.capabilities.is_adaptive()) resolution = Tolerance{1e-3, 1e-3};
    EXPECT_EQ(unsupported_reason(scheme, decay_through(0.5), resolution),
              "steps explicitly: component 0 is an algebraic row (order 0)");
  }
  EXPECT_EQ(refused, 4);
}

TEST(AlgebraicRefusals, LinearSmoothnessNamesTheComponent) {
  EXPECT_THAT([] { linear_smoothness(decay_through(0.5).components, Matrix::Ones(2, 2)); },
              testing::ThrowsMessage<std::invalid_argument>(HasSubstr("component 0 has order 0")));
}

TEST(AlgebraicRefusals, SplittingLeavesThemAlone) {
  const auto problem = decay_through(1.5);
  EXPECT_EQ(splitting_up_to_one(problem), (OrderSplitting{{0.0}, {1.0, 0.5}}));
  EXPECT_EQ(commensurate_splitting(problem), (OrderSplitting{{0.0}, {0.5, 0.5, 0.5}}));
  const Problem all = split_orders(problem, *commensurate_splitting(problem));
  EXPECT_EQ(all.size(), 4);
  EXPECT_EQ(all.components[0].order, 0.0);
  EXPECT_EQ(all.components[0].initial, std::vector{1.0});
}

}  // namespace
}  // namespace fde::bench
