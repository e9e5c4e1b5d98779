// Rates of the multistep rules with start weights, two-sided, at the end and in the first steps, for
// solutions that start like t^g. Their errors come to rounding on short grids, so each rule has its own range
// of steps.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "observers/rate.hpp"
#include "problem/smoothness.hpp"
#include "references/reference_of.hpp"
#include "start_weights/start_powers.hpp"
#include "support/testing.hpp"

namespace fde {
namespace {

struct Case {
  std::string name;
  std::string_view scheme;
  Scene scene;
  std::vector<double> orders;
  double rate;
  int coarsest;
};

// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest looks for this name.
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

// Where rules of higher rate are in their asymptotic range before they come to rounding.
std::vector<Case> cases() {
  std::vector<Case> all;
  const auto add = [&](const std::string& name, Scene scene, const std::vector<double>& orders, bool slow) {
    scene.problem.end = 1.0;
    for (const auto* id : {"bdf2", "newton_gregory_2", "fractional_trapezoidal"})
      all.push_back({fmt::format("{}__{}", name, id), id, scene, orders, 2.0, 256});
    if (!slow) return;
    for (const auto* id : {"bdf3", "newton_gregory_3"})
      all.push_back({fmt::format("{}__{}", name, id), id, scene, orders, 3.0, 64});
  };
  for (const double order : {0.2, 0.5, 0.8, 1.3, 1.7}) {
    add(fmt::format("relaxation_{:.0f}", 10 * order), scene_of("relaxation", {{"gamma", order}}), {order},
        order > 0.2);
  }
  add("damped_oscillator", scene_of("damped_oscillator"), {0.5, 1.0}, true);
  return all;
}

class MultistepRate : public testing::TestWithParam<Case> {};
class MultistepFirstSteps : public testing::TestWithParam<Case> {};

// Of order 0.2, and of rules of rate 3, the powers of h are too close to each other to tell in doubles.
std::vector<Case> cases_of_first_steps() {
  auto some = cases();
  std::erase_if(some, [](const Case& c) { return c.orders.front() == 0.2 || c.rate > 2.0; });
  return some;
}

// An error has the powers rate and 1 + r of h, r > rate - 1 any sum of orders. The first two of these are
// close to the rate: known from theory, they are taken out, e(h) - 2^q e(h/2).
TEST_P(MultistepRate, AtTheEndIsThatOfTheory) {
  const auto& [name, id, scene, orders, rate, coarsest] = GetParam();
  const Scheme& scheme = *find_scheme(id);
  const Vec exact = reference_of(scene).at(1.0).value;
  std::vector<Vec> errors;
  for (int steps = coarsest; steps <= 64 * coarsest; steps *= 2) {
    const auto path = scheme.solve(scene.problem, Grid{1.0, steps}, {.at = {1.0}});
    errors.emplace_back(columns_at(scene.outputs, 1.0, path.y.col(0)) - exact);
  }
  auto steps_of_powers = orders;
  steps_of_powers.push_back(1.0);
  auto later = power_lattice({0.0}, steps_of_powers, rate + 1.0);
  const double covered = rate - 1.0 + distinct_powers;
  std::erase_if(later, [=](double r) { return r < covered; });
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::size_t i = 0; i + 1 < errors.size(); ++i)
      errors[i] -= std::pow(2.0, 1.0 + later[k]) * errors[i + 1];
    errors.pop_back();
  }
  std::vector<ErrorAt> points;
  std::string rows;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    points.push_back({std::ldexp(1.0 / coarsest, -static_cast<int>(i)), errors[i].cwiseAbs().maxCoeff()});
    rows += fmt::format("{:.3e} {:.3e}\n", points.back().h, points.back().error);
  }
  const Fit fit = fit_rate(points);
  const double theory = scheme.expected_rate(scene.problem, scene.smoothness, 1.0, Norm::end);
  EXPECT_DOUBLE_EQ(theory, rate);
  ASSERT_GE(fit.points, 3U) << rows;
  EXPECT_NEAR(fit.slope, theory, 0.1) << rows;
}

// The steps that are solved together, of length h -> 0: the first power without a start weight is left,
// h^(g+r). It is the rate in the maximum norm where it is below the rule's.
TEST_P(MultistepFirstSteps, HaveTheRateOfTheory) {
  const auto& [name, id, scene, orders, rate, coarsest] = GetParam();
  const Scheme& scheme = *find_scheme(id);
  const auto reference = reference_of(scene);
  const double theory = scheme.expected_rate(scene.problem, scene.smoothness, 1.0, Norm::first_step);
  const int steps = static_cast<int>(scheme.start_powers(scene.problem).size()) - 1;
  std::vector<ErrorAt> points;
  std::string rows;
  for (int k = 0; k < 5; ++k) {
    const double h = std::pow(10.0, -(4.0 + k) / theory);
    Scene first = scene;
    first.problem.end = steps * h;
    const auto path = scheme.solve(first.problem, Grid{first.problem.end, steps}, {});
    double error = 0.0;
    for (Eigen::Index c = 1; c < path.y.cols(); ++c) {
      const Vec difference =
          columns_at(scene.outputs, path.time(c), path.y.col(c)) - reference.at(path.time(c)).value;
      error = std::max(error, difference.cwiseAbs().maxCoeff());
    }
    points.push_back({h, error});
    rows += fmt::format("{:.3e} {:.3e}\n", h, error);
  }
  const Fit fit = fit_rate(points);
  ASSERT_GE(fit.points, 3U) << rows;
  EXPECT_NEAR(fit.slope, theory, 0.1) << rows;
}

INSTANTIATE_TEST_SUITE_P(, MultistepRate, testing::ValuesIn(cases()),
                         [](const auto& test) { return test.param.name; });
INSTANTIATE_TEST_SUITE_P(, MultistepFirstSteps, testing::ValuesIn(cases_of_first_steps()),
                         [](const auto& test) { return test.param.name; });

// D^g y = Gamma(p+1)/Gamma(p+1-g) t^(p-g) + t^p - y is t^p. With p = g + rate + 1 nothing but the rule's own
// error is left, which comes to rounding soon: few steps.
TEST(MultistepRateOf, SmoothSolutionsIsThatOfTheRule) {
  struct Rule {
    const char* id;
    double rate;
    std::vector<double> orders;
  };
  for (const auto& [id, rate, orders] :
       {Rule{"bdf4", 4.0, {0.5, 1.3, 1.7}}, {"bdf5", 5.0, {0.5, 1.7}}, {"bdf6", 6.0, {0.5, 1.3}}}) {
    for (const double g : orders) {
      const double p = g + rate + 1.0;
      Scene scene = scene_of("power", {{"gamma", g}, {"p", p}});
      std::vector<ErrorAt> points;
      std::string rows;
      for (const int steps : {160, 200, 250, 320}) {
        const auto path = solve(id, scene.problem, steps, {.at = {scene.problem.end}});
        points.push_back({1.0 / steps, std::abs(path.y(0, 0) - std::pow(scene.problem.end, p))});
        rows += fmt::format("{} {:.3e}\n", steps, points.back().error);
      }
      const Fit fit = fit_rate(points);
      ASSERT_GE(fit.points, 3U) << id << ' ' << g << '\n' << rows;
      EXPECT_NEAR(fit.slope, rate, 0.1) << id << ' ' << g << '\n' << rows;
    }
  }
}

}  // namespace
}  // namespace fde
