// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/exact.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "support/refusal_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// E_{1/2}(-t^{1/2}) = e^t erfc(t^{1/2}).
TEST(Exact, HasTheValuesWithinTheBoundsAtTimesInAnyOrder) {
  const std::vector<double> times{4.0, 0.25, 1.0, 0.25};
  const auto table = exact(scene_of("relaxation"), times);
  EXPECT_THAT(table.names, testing::ElementsAre("y"));
  for (Eigen::Index i = 0; const double t : times) {
    const double known = std::exp(t) * std::erfc(std::sqrt(t));
    EXPECT_LE(std::abs(table.values(0, i) - known), table.bounds(0, i) + 4e-16 * known) << t;
    ++i;
  }
  EXPECT_EQ(table.values(0, 1), table.values(0, 3));
}

TEST(Exact, HasBoundsOfTheColumnsOnly) {
  const Scene disc = scene_of("rolling_disc");
  const auto table = exact(disc, {1.0});
  EXPECT_EQ(table.bounds.rows(), std::ssize(disc.outputs.names));
  EXPECT_EQ(table.values.rows(), std::ssize(table.names));
  EXPECT_THAT(table.names, testing::IsSupersetOf({"energy", "constraint", "lambda1"}));
}

TEST(Exact, InDigitsRoundsToTheSameDoubles) {
  const Scene scene = scene_of("relaxation");
  const std::vector<double> times{0.5, 1.0};
  const auto decimals = exact_in_digits(scene, "relaxation", times, 30);
  const auto table = exact(scene, times);
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_EQ(std::stod(decimals[i].front().value), table.values(0, static_cast<Eigen::Index>(i)));
  EXPECT_EQ(decimals[1].front().value, "0.427583576155807004410750344491");
}

TEST(Exact, NamesTheFieldThatItRefuses) {
  const Scene one_end = scene_of("relaxation"), two_ends = scene_of("two_sided_constraint");
  EXPECT_EQ(refusal_of([&] {
              exact(one_end, {1.0, -1.0});
            }),
            "<times> = -1: must be a finite number of at least 0");
  EXPECT_EQ(refusal_of([&] { exact(one_end, {std::nan("")}); }),
            "<times> = nan: must be a finite number of at least 0");
  EXPECT_EQ(refusal_of([&] { exact(two_ends, {2.5}); }),
            "<times> = 2.5: must be in [0, 2], the time of the scene");
  EXPECT_EQ(refusal_of([&] { exact_in_digits(one_end, "relaxation", {1.0}, 0); }),
            "<digits> = 0: must be a whole number from 1 to 100000");
  EXPECT_EQ(refusal_of([&] { exact_in_digits(two_ends, "two_sided_constraint", {1.0}, 40); }),
            "<digits> = 40: scene two_sided_constraint has no exact solution in digits, only what is known "
            "in double");
}

}  // namespace
}  // namespace fde::bench
