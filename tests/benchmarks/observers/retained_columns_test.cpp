// SPDX-License-Identifier: MIT
// Columns are stored after each step, so that the states need not be stored.

#include "fdebench/benchmarks/observers/retained_columns.hpp"

#include <gtest/gtest.h>

#include "support/testing.hpp"

namespace fde::bench {
namespace {

TEST(RetainedColumns, AreThoseOfTheKeptStates) {
  const Scene scene = scene_of("fractional_diffusion_2d");
  for (const std::vector<double>& times : {std::vector<double>{}, {0.0, 0.25, 1.0}}) {
    RetainedColumns kept(scene.outputs, times);
    const auto path = solve("l1", scene.problem, 64,
                            {.output_times = times, .observer = [&](double t, In y) { kept.observe(t, y); }});
    EXPECT_EQ(kept.times(), path.times);
    EXPECT_EQ(kept.columns(), columns_of(scene.outputs, path));
  }
}

TEST(RetainedColumns, AreInTheUnitOfTheScene) {
  const Scene scene = scene_of("fractional_diffusion");
  RetainedColumns plain(scene.outputs, {0.0}), halves(scene.outputs, {0.0}, 0.5);
  const Vec y = Vec::LinSpaced(scene.problem.size(), 0.0, 1.0);
  plain.observe(0.0, y);
  halves.observe(0.0, 2.0 * y);
  EXPECT_EQ(plain.columns(), halves.columns());
}

TEST(RetainedColumns, AreNoneBeforeTheFirstStep) {
  const Scene scene = scene_of("relaxation");
  const RetainedColumns kept(scene.outputs, {1.0});
  EXPECT_TRUE(kept.times().empty());
  EXPECT_EQ(kept.columns().cols(), 0);
}

}  // namespace
}  // namespace fde::bench
