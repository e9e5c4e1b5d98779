// Scenes that are posed at both ends: their rates, what is known about them, and that their equations are
// those of the extremum they come from.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "caputo.hpp"
#include "rate.hpp"
#include "testing.hpp"

namespace fde {
namespace {

constexpr std::array both_schemes{"product_trapezoidal", "grunwald_letnikov"};

// Largest error of any column at any time.
double largest_error(const Scene& scene, std::string_view scheme, int steps) {
  const auto path = solve(scheme, scene.problem, steps);
  EXPECT_EQ(path.outcome, Outcome::finished);
  TruthTable truth(scene);
  return (columns_of(scene.outputs, path) - truth.at(path.grid, path.steps)).cwiseAbs().maxCoeff();
}

struct Made {
  std::string scene;
  double alpha;
};
// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest looks for this name.
void PrintTo(const Made& made, std::ostream* out) { *out << made.scene << " alpha = " << made.alpha; }

class MadeScene : public testing::TestWithParam<Made> {
 protected:
  const Scene scene_ = scene_of(GetParam().scene, {{"alpha", GetParam().alpha}});
};

TEST_P(MadeScene, ShowsTheRateAtAllTimes) {
  for (const auto* id : both_schemes) {
    std::vector<ErrorAt> errors;
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
        EXPECT_LT(scene_.constraint.drift(path.grid.time(n), columns.col(n)), 1e-14) << id << " " << n;
    }
  }
}

// The made w and r against the definitions: w = D^alpha q1, r its mirror image or J_-^(1-alpha) of g.
TEST_P(MadeScene, HasTheDerivativesOfItsMotion) {
  const double alpha = GetParam().alpha, end = scene_.problem.end;
  const auto column = [&](std::string_view name) -> Function {
    const auto at = std::ranges::find(scene_.outputs.names, name) - scene_.outputs.names.begin();
    return [=, this](double t) { return scene_.exact.at(t).value[at]; };
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
                         testing::Values(Made{"two_sided_constraint", 0.3}, Made{"two_sided_constraint", 0.8},
                                         Made{"fractional_hamilton", 0.3}, Made{"fractional_hamilton", 0.8}),
                         [](const auto& test) {
                           return fmt::format("{}_{:.0f}", test.param.scene, 10 * test.param.alpha);
                         });

// The first variation of int 1/2 q'^2 - u + mu f + force.q dt - p(T).q(T) in a direction e with e(0) = 0:
//   int p.e' + (mu q'.dA/dw) D^alpha e1 - f_pi.e dt = p(T).e(T), f_pi = -pi' the right-hand side of the
// momenta. It knows of no right derivative: its transposition is what the scene does.
TEST(FractionalHamilton, MakesTheFirstVariationZero) {
  const double alpha = 0.4, epsilon = 0.7;
  const auto scene = scene_of("fractional_hamilton", {{"alpha", alpha}, {"epsilon", epsilon}});
  const double end = scene.problem.end;
  const auto first = [](double t, double order) { return caputo_of_power(3.0, order, t); };
  const auto second = [](double t, double order) { return caputo_of_power(2.0, order, t); };
  const auto integrand = [&](double t) {
    const Vec c = scene.exact.at(t).value;  // q1 q2 v1 v2 w1 r1 p1 p2 mu
    Vec y(6), f(6);
    y << c[0], c[1], c[4], c[5], c[6] + c[5], c[7];
    scene.problem.rhs(t, y, f);
    return c[6] * first(t, 1.0) + c[7] * second(t, 1.0) + epsilon * c[8] * c[2] * first(t, alpha) -
           f[4] * first(t, 0.0) - f[5] * second(t, 0.0);
  };
  const Vec last = scene.exact.at(end).value;
  EXPECT_NEAR(integral(integrand, 0.0, end), last[6] * first(end, 0.0) + last[7] * second(end, 0.0), 1e-9);
}

TEST(FractionalExtremum, IsExactWithoutASpring) {
  for (const double alpha : {0.501, 0.6, 0.75, 0.9, 0.999, 1.0}) {
    const auto scene = scene_of("fractional_extremum", {{"alpha", alpha}});
    for (const auto* id : both_schemes) EXPECT_LT(largest_error(scene, id, 256), 1e-12) << alpha << id;
  }
}

// y'' = k y.
TEST(FractionalExtremum, OfOrderOneIsAHyperbolicSine) {
  const double k = 4.0;
  auto scene = scene_of("fractional_extremum", {{"alpha", 1.0}, {"k", k}});
  scene.exact = {[=](double t) -> Truth {
    return {Vec::Constant(1, std::sinh(2.0 * t) / std::sinh(2.0)), Vec::Zero(1)};
  }};
  std::vector<ErrorAt> errors;
  for (int steps = 64; steps <= 1024; steps *= 2)
    errors.push_back({1.0 / steps, largest_error(scene, "product_trapezoidal", steps)});
  EXPECT_NEAR(fit_rate(errors).slope, 2.0, 0.1);
}

// y at the times, of the least of 1/2 int p^2 + k y^2 over all p that are constant on cells that become
// shorter towards the end, y = J^alpha p, y(1) = 1; int y^2 by Gauss's rule of two points.
Vec dense_minimum(double alpha, double k, int cells, const std::vector<double>& times) {
  const Vec places = Vec::NullaryExpr(
      cells + 1, [&](Eigen::Index j) { return 1.0 - std::pow(1.0 - static_cast<double>(j) / cells, 4.0); });
  const auto weights = [&](double t) -> Vec {
    return Vec::NullaryExpr(cells, [&](Eigen::Index j) {
      const auto past = [&](double from) { return std::pow(std::max(t - from, 0.0), alpha); };
      return (past(places[j]) - past(places[j + 1])) / std::tgamma(alpha + 1.0);
    });
  };
  Matrix form = (places.tail(cells) - places.head(cells)).asDiagonal();
  Matrix points(cells, 2 * cells);
  for (Eigen::Index j = 0; j < cells; ++j) {
    const double length = form(j, j), middle = places[j] + length / 2, off = length / (2 * std::sqrt(3.0));
    points.col(2 * j) = std::sqrt(k * length / 2) * weights(middle - off);
    points.col(2 * j + 1) = std::sqrt(k * length / 2) * weights(middle + off);
  }
  form.noalias() += points * points.transpose();
  const Vec at_end = weights(1.0), p = form.llt().solve(at_end);
  return Vec::NullaryExpr(std::ssize(times), [&](Eigen::Index i) {
    return weights(times[static_cast<std::size_t>(i)]).dot(p) / at_end.dot(p);
  });
}

TEST(FractionalExtremum, WithASpringIsTheDenseMinimum) {
  for (const auto& order_and_spring : {std::pair{0.75, 5.0}, {0.9, 20.0}}) {
    const double alpha = order_and_spring.first, k = order_and_spring.second;
    const auto scene = scene_of("fractional_extremum", {{"alpha", alpha}, {"k", k}});
    const auto path = solve("product_trapezoidal", scene.problem, 4096, {.keep = {1024, 2048, 3072}});
    const Vec y = columns_of(scene.outputs, path).row(0).transpose();
    const auto off = [&](int cells) {
      return (dense_minimum(alpha, k, cells, {0.25, 0.5, 0.75}) - y).cwiseAbs().maxCoeff();
    };
    const double coarse = off(100), fine = off(400);
    EXPECT_LT(fine, 1e-5);
    EXPECT_LT(fine, coarse / 3.0);
    // Without the spring y is far from that.
    const Scene free = scene_of("fractional_extremum", {{"alpha", alpha}});
    EXPECT_GT(std::abs(free.exact.at(0.5).value[0] - y[1]), 0.1);
  }
}

}  // namespace
}  // namespace fde
