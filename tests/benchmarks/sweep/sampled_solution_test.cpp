// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/sampled_solution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// q(t) = cos(w t) without damping: its polyline is to be right everywhere, not only at the start.
double worst_distance(const SampledSolution& sampled, double w) {
  const auto& t = sampled.t;
  double worst = 0.0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    for (const double part : {0.25, 0.5, 0.75}) {
      const double between =
          std::lerp(*sampled.columns.values[0][i - 1], *sampled.columns.values[0][i], part);
      worst = std::max(worst, std::abs(between - std::cos(w * std::lerp(t[i - 1], t[i], part))));
    }
  }
  return worst;
}

TEST(SampledSolutions, FollowOscillationsToTheEnd) {
  for (const double w : {1.0, 40.0, 2.0 * M_PI * 12.0}) {  // the last has a whole period between equal times
    const Scene scene = scene_of("fractional_oscillator", {{"nu", 2.0}, {"w2", w * w}});
    const auto sampled = sample_solution(scene, reference_of(scene), {.times = 8000});
    EXPECT_LT(worst_distance(sampled, w), 0.02) << w;
    EXPECT_LT(sampled.t.size(), 8000U) << "no more than it takes";
  }
}

TEST(SampledSolutions, ShareFewTimesEvenly) {
  const double w = 100.0;
  const Scene scene = scene_of("fractional_oscillator", {{"nu", 2.0}, {"w2", w * w}});
  const auto sampled = sample_solution(scene, reference_of(scene), {.times = 1000});
  const auto middle = std::ranges::lower_bound(sampled.t, 0.5 * scene.problem.end) - sampled.t.begin();
  EXPECT_NEAR(static_cast<double>(middle), 0.5 * static_cast<double>(sampled.t.size()), 100.0);
}

}  // namespace
}  // namespace fde::bench
