// SPDX-License-Identifier: MIT
// Manufactured solutions with right derivatives: their rates, their derivatives and constraints, and that the
// equations are those of the extremum from which they follow.

#include "support/two_sided_scenes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "fdebench/benchmarks/observers/rate.hpp"
#include "support/caputo.hpp"

namespace fde::bench {
namespace {

struct ManufacturedProblem {
  std::string scene;
  double alpha;
};
// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest looks for this name.
void PrintTo(const ManufacturedProblem& made, std::ostream* out) {
  *out << made.scene << " alpha = " << made.alpha;
}

class MadeScene : public testing::TestWithParam<ManufacturedProblem> {
 protected:
  const Scene scene_ = scene_of(GetParam().scene, {{"alpha", GetParam().alpha}});
};

TEST_P(MadeScene, ShowsTheRateAtAllTimes) {
  for (const auto* id : both_schemes) {
    std::vector<ErrorSample> errors;
    for (int steps = 128; steps <= 2048; steps *= 2)
      errors.push_back({scene_.problem.end / steps, largest_error(scene_, id, steps)});
    const double expected =
        find_scheme(id)->expected_rate(scene_.problem, scene_.smoothness, 1.0, Norm::maximum);
    EXPECT_EQ(expected, std::string_view(id) == "grunwald_letnikov" ? 1.0 : 2.0);
    const Fit fit = fit_rate(errors);
    EXPECT_EQ(fit.points, 5U);
    EXPECT_NEAR(fit.slope, expected, 0.1) << id;
    EXPECT_GT(fit.correlation, 0.999) << id;
  }
}

TEST_P(MadeScene, KeepsItsConstraintToRounding) {
  for (const auto* id : both_schemes) {
    for (const int steps : {64, 4096}) {
      const auto path = solve(id, scene_.problem, steps);
      const Rows columns = columns_of(scene_.outputs, path);
      for (int n = 0; n <= steps; ++n)
        EXPECT_LT(scene_.constraint.drift(path.time(n), columns.col(n)), 1e-14) << id << " " << n;
    }
  }
}

// The manufactured w and r against the definitions: w = D^alpha q1, r its mirror image or J_-^(1-alpha) of g.
TEST_P(MadeScene, HasTheDerivativesOfItsMotion) {
  const double alpha = GetParam().alpha, end = scene_.problem.end;
  const auto column = [&](std::string_view name) -> Function {
    const auto at = std::ranges::find(scene_.outputs.names, name) - scene_.outputs.names.begin();
    return [=, this](double t) { return scene_.reference.at(t).value[at]; };
  };
  const auto velocity = column("v1");
  for (const double t : {0.3, 1.1, 1.7}) {
    EXPECT_NEAR(column("w1")(t), fractional_integral(velocity, 1.0 - alpha, t), 1e-10);
    if (GetParam().scene == "two_sided_constraint") {
      EXPECT_NEAR(column("r1")(t), right_caputo(velocity, alpha, t, end), 1e-10);
      continue;
    }
    const auto g = [&](double s) { return 0.5 * column("mu")(s) * velocity(s); };
    EXPECT_NEAR(column("r1")(t), -right_caputo(g, alpha, t, end), 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(, MadeScene,
                         testing::Values(ManufacturedProblem{"two_sided_constraint", 0.3},
                                         ManufacturedProblem{"two_sided_constraint", 0.8},
                                         ManufacturedProblem{"fractional_hamilton", 0.3},
                                         ManufacturedProblem{"fractional_hamilton", 0.8}),
                         [](const auto& test) {
                           return fmt::format("{}_{:.0f}", test.param.scene, 10 * test.param.alpha);
                         });

// The first variation of int 1/2 q'^2 - u + mu f + force.q dt - p(T).q(T) in a direction e with e(0) = 0:
//   int p.e' + (mu q'.dA/dw) D^alpha e1 - f_pi.e dt = p(T).e(T), f_pi = -pi' the right-hand side of the
// momenta. It contains no right derivative; the scene is its transposition.
TEST(FractionalHamilton, MakesTheFirstVariationZero) {
  const double alpha = 0.4, epsilon = 0.7;
  const auto scene = scene_of("fractional_hamilton", {{"alpha", alpha}, {"epsilon", epsilon}});
  EXPECT_EQ(
      find_scheme("grunwald_letnikov")->expected_rate(scene.problem, scene.smoothness, 1.0, Norm::maximum),
      1.0);
  const double end = scene.problem.end;
  const auto first = [](double t, double order) { return caputo_derivative_of_power(3.0, order, t); };
  const auto second = [](double t, double order) { return caputo_derivative_of_power(2.0, order, t); };
  const auto integrand = [&](double t) {
    const Vec c = scene.reference.at(t).value;  // q1 q2 v1 v2 w1 r1 p1 p2 mu
    Vec y(6), f(6);
    y << c[0], c[1], c[4], c[5], c[6] + c[5], c[7];
    scene.problem.rhs(t, y, f);
    return c[6] * first(t, 1.0) + c[7] * second(t, 1.0) + epsilon * c[8] * c[2] * first(t, alpha) -
           f[4] * first(t, 0.0) - f[5] * second(t, 0.0);
  };
  const Vec last = scene.reference.at(end).value;
  EXPECT_NEAR(integral(integrand, 0.0, end), last[6] * first(end, 0.0) + last[7] * second(end, 0.0), 1e-9);
}

}  // namespace
}  // namespace fde::bench
