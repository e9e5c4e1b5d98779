// SPDX-License-Identifier: MIT
// A right-hand side that jumps: the rate of a scheme holds where the jump is at a time of the grid. Inside a
// step it reduces the rate to 1.

#include <gtest/gtest.h>

#include "fdebench/benchmarks/observers/rate.hpp"
#include "fdebench/schemes/stepping/rates.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// The load of the Bagley-Torvik plate ends at t = 1.
Scene loaded_until_one(double end) {
  Scene scene = scene_of("bagley_torvik");
  scene.problem.end = end;
  return scene;
}

double expected(const Scheme& scheme, const Scene& scene, int steps, Norm norm) {
  const Grid grid{scene.problem.end, steps};
  return theoretical_rate(scheme, scene.problem, scene.smoothness, grid, norm).value();
}

class JumpRate : public testing::TestWithParam<const char*> {
 protected:
  const Scheme& scheme_ = *find_scheme(GetParam());
};

TEST_P(JumpRate, IsThatOfTheSchemeWhereTheGridMeetsTheJump) {
  const Scene even = loaded_until_one(2.0), odd = loaded_until_one(1.6875);
  for (const Norm norm : {Norm::end, Norm::maximum}) {
    const double whole = expected(scheme_, even, 64, norm);
    EXPECT_EQ(expected(scheme_, odd, 27, norm), whole);  // the step is 1/16
    EXPECT_EQ(expected(scheme_, odd, 64, norm), std::min(whole, 1.0));
  }
}

// The position of the jump within its step changes with the number of steps, and so does the error: the
// largest of several errors falls like h.
TEST_P(JumpRate, IsOneWhereTheJumpFallsInsideAStep) {
  const Scene scene = loaded_until_one(1.6875);
  MemoizedReference reference(scene);
  std::vector<ErrorSample> points;
  for (const int steps : {200, 400, 800, 1600}) {
    double largest = 0.0;
    for (int more = 0; more < 16; ++more) {
      const double end = scene.problem.end;
      const auto path = scheme_.solve(scene.problem, Grid{end, steps + more}, {.output_times = {end}});
      const Rows errors = columns_of(scene.outputs, path) - reference.at(path.times);
      largest = std::max(largest, errors.cwiseAbs().maxCoeff());
    }
    points.push_back({scene.problem.end / steps, largest});
  }
  const double theory = expected(scheme_, scene, 200, Norm::end);
  EXPECT_EQ(theory, 1.0);
  EXPECT_NEAR(fit_rate(points).slope, theory, 0.1);
}

INSTANTIATE_TEST_SUITE_P(, JumpRate,
                         testing::Values("product_trapezoidal", "bdf2", "l1_2", "multi_term_trapezoidal"),
                         text_of_param);

}  // namespace
}  // namespace fde::bench
