// SPDX-License-Identifier: MIT
// The boundary of linear stability regions as polylines.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/schemes/diagnostics/stability_region.hpp"

namespace fde::bench {
namespace {

// At order 1 the schemes are classical methods.
TEST(RegionBoundary, OfBackwardEulerIsACircle) {
  const auto pieces = region_boundary(*find_scheme("grunwald_letnikov"), 1.0, 20);
  ASSERT_EQ(pieces.size(), 1U);
  for (const auto& [theta, z] : pieces.front()) EXPECT_NEAR(std::abs(1.0 - z), 1.0, 1e-9);
}

TEST(RegionBoundary, OfHeunsMethodIsWhereItsPolynomialHasSizeOne) {
  const auto pieces = region_boundary(*find_scheme("adams_pc"), 1.0, 20);
  ASSERT_FALSE(pieces.empty());
  for (const auto& piece : pieces) {
    for (const auto& [theta, z] : piece) EXPECT_NEAR(std::abs(1.0 + z + z * z / 2.0), 1.0, 1e-9);
  }
}

// The root locus continues where other modes already grow; those parts are not boundary.
TEST(RegionBoundary, OfAPredictorHasNoPointInsideOrOutsideOfTheRegion) {
  const Scheme& scheme = *find_scheme("multi_term_pc");
  const double order = 1.5;
  const auto is_stable = [&](ComplexValue z) {
    return is_linearly_stable(scheme, test_problem(scheme, order, z), 1.0);
  };
  for (const auto& piece : region_boundary(scheme, order, 12)) {
    ASSERT_GE(piece.size(), 3U);
    const ComplexValue z = piece[1].z, along = piece[2].z - piece[0].z;
    const ComplexValue out = ComplexValue(0.0, 0.02 * std::abs(z)) * along / std::abs(along);
    EXPECT_NE(is_stable(z + out), is_stable(z - out)) << z;
  }
}

}  // namespace
}  // namespace fde::bench
