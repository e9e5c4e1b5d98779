// SPDX-License-Identifier: MIT
// References of problems with algebraic rows that determine their own unknown, or that constrain others.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/reference/nonlinear/collocation.hpp"
#include "support/algebraic_problems.hpp"
#include "support/series_values.hpp"
#include "support/testing.hpp"

namespace fde::reference {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

void expect_within_bounds(const ReferenceValue& found, const Vec& exact) {
  for (Eigen::Index i = 0; i < exact.size(); ++i) {
    EXPECT_NEAR(found.value[i], exact[i], found.bound[i]) << i;
    EXPECT_LT(found.bound[i], 1e-13) << i;
  }
}

// Against the power series in t^(1/10), 300 terms at 60 digits.
TEST(AlgebraicRowsReference, OfASingularReactionIsThePowerSeries) {
  for (const auto& [alpha, t, columns] : bench::series_values()) {
    auto scene =
        bench::scene_of("fractional_constraint_nonlinear", {{"alpha", alpha}, {"formulation", "multiplier"}});
    scene.name.clear();  // bypasses the cache
    scene.problem.end = t;
    expect_within_bounds(reference_of(scene).at(t), columns);
  }
}

TEST(AlgebraicRowsReference, OfAnUnknownThatCanBeEliminatedIsThatOfTheOthers) {
  for (const double order : {0.5, 1.0, 1.5}) {
    const Reference through = reference_solution(bench::decay_through(order)),
                    alone = reference_solution(bench::decay(order));
    for (const double t : {1e-3, 0.5, 2.0}) {
      const Vec both = alone.at(t).value.replicate(2, 1);
      expect_within_bounds(through.at(t), both);
    }
  }
}

// lambda(0) is minus infinity here, and 0 and 3 are guesses; the other initial values are exact. So is the
// initial value of an unknown whose own algebraic row holds at t = 0.
TEST(AlgebraicRowsReference, KnowsNothingOfAGuessedMultiplierAtTheStart) {
  const bench::AlgebraicPlane plane{.alpha = 0.5};
  for (const double guess : {0.0, 3.0}) {
    const Reference reference = reference_solution(plane.multiplier(guess));
    const Vec bound = reference.at(0.0).bound;
    EXPECT_EQ(bound.head(6), Vec::Zero(6)) << guess;
    EXPECT_EQ(bound[6], std::numeric_limits<double>::infinity()) << guess;
    EXPECT_TRUE(reference.at(1e-3).bound.allFinite()) << guess;
  }
  EXPECT_EQ(reference_solution(bench::decay_through(0.5)).at(0.0).bound, Vec::Zero(2));
}

// v' = -k q + a lambda with the constraint a.v + b.w = c0, against the form without multiplier.
TEST(AlgebraicRowsReference, OfALinearConstraintIsThatOfTheIntegratedForm) {
  const bench::AlgebraicPlane plane{.alpha = 0.5};
  const Reference with = reference_solution(plane.multiplier(0.0)),
                  without = reference_solution(plane.integrated());
  for (const double t : {1e-3, 0.5, 2.0}) {
    const auto found = with.at(t), known = without.at(t);
    for (const Eigen::Index k : {0, 1, 4, 5}) {
      EXPECT_NEAR(found.value[k], known.value[k], found.bound[k] + known.bound[k]) << k;
      EXPECT_LT(found.bound[k], 1e-13);
    }
  }
}

TEST(AlgebraicRowsReference, NeedsOrdersWhosePowersStartAboveTheSmallestDouble) {
  const bench::AlgebraicPlane plane{.alpha = 0.95};
  EXPECT_THAT([&] { reference_table(plane.multiplier(0.0)); },
              ThrowsMessage<std::runtime_error>(HasSubstr("takes no order below 0.063 with algebraic rows")));
}

}  // namespace
}  // namespace fde::reference
