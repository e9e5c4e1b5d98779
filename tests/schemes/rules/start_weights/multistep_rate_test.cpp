// SPDX-License-Identifier: MIT
// Rates of the multistep rules with starting weights, tested from below and above, at the end and in the
// first steps, for solutions with a term t^g. The errors reach rounding on short grids, so each rule has its
// own range of steps.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/observers/rate.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"
#include "fdebench/schemes/rules/start_weights/start_weights.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

struct MultistepCase {
  std::string name;
  std::string_view scheme;
  Scene scene;
  std::vector<double> orders;
  double rate;
  int coarsest;
};

// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest looks for this name.
void PrintTo(const MultistepCase& c, std::ostream* out) { *out << c.name; }

// The cases in which the asymptotic range of rules of rate 3 begins before rounding.
std::vector<MultistepCase> multistep_cases() {
  std::vector<MultistepCase> all;
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
  const auto add_equation = [&](const std::string& name, Scene scene, double step) {
    scene.problem.end = 1.0;
    all.push_back({name + "__multi_term_bdf2", "multi_term_bdf2", scene, {step}, 2.0, 512});
  };
  add_equation("damped_oscillator", scene_of("damped_oscillator"), 0.5);
  add_equation("damped_oscillator_125_75", scene_of("damped_oscillator", {{"alpha", 1.25}, {"beta", 0.75}}),
               0.25);
  const auto two_terms = [](double leading, double term) {
    return scene_of("multi_term", {{"order", leading},
                                   {"force", "linear"},
                                   {"load", "constant"},
                                   {"du0", 0.5},
                                   {"c", 0.0},
                                   {"alpha", std::vector{1.5}},
                                   {"b", std::vector{0.0}},
                                   {"beta", std::vector{term}},
                                   {"d", std::vector{0.7}}});
  };
  add_equation("multi_term_8_4", two_terms(0.8, 0.4), 0.2);
  add_equation("multi_term_16_8", two_terms(1.6, 0.8), 0.2);
  return all;
}

// The cases for the first steps: without rules of rate 3, whose leading error term has such a small factor
// that the next terms hide it, and without multi-term equations, whose rows have other orders.
std::vector<MultistepCase> cases_of_first_steps() {
  auto some = multistep_cases();
  std::erase_if(some, [](const MultistepCase& c) { return c.rate > 2.0 || c.scheme == "multi_term_bdf2"; });
  return some;
}

class MultistepRate : public testing::TestWithParam<MultistepCase> {};
class MultistepFirstSteps : public testing::TestWithParam<MultistepCase> {};

// The sums of orders and integers, from the first that has no starting weight on.
std::vector<double> powers_without_start_weights(const MultistepCase& c) {
  auto steps = c.orders;
  steps.push_back(1.0);
  auto powers = power_lattice({0.0}, steps, c.rate + 1.0);
  const double covered = c.rate - 1.0 + power_separation;
  std::erase_if(powers, [=](double r) { return r < covered; });
  return powers;
}

// Richardson elimination of the term h^q, known from theory, from errors with steps h, h/2, h/4, ...:
// e(h) - 2^q e(h/2).
template <class Error>
void take_out(double q, std::vector<Error>& errors) {
  for (std::size_t i = 0; i + 1 < errors.size(); ++i) errors[i] -= std::pow(2.0, q) * errors[i + 1];
  errors.pop_back();
}

template <class Error>
void expect_rate(const std::vector<Error>& errors, double h, double theory) {
  std::vector<ErrorSample> points;
  std::string rows;
  for (const auto& error : errors) {
    points.push_back({h, error.cwiseAbs().maxCoeff()});
    rows += fmt::format("{:.3e} {:.3e}\n", h, points.back().error);
    h /= 2.0;
  }
  const Fit fit = fit_rate(points);
  ASSERT_GE(fit.points, 3U) << rows;
  EXPECT_NEAR(fit.slope, theory, 0.1) << rows;
}

// The error has the powers `rate` and 1 + r of h, for r without a starting weight; two of them are close to
// the rate and are eliminated.
TEST_P(MultistepRate, AtTheEndIsThatOfTheory) {
  const auto& [name, id, scene, orders, rate, coarsest] = GetParam();
  const Scheme& scheme = *find_scheme(id);
  const Vec exact = reference_of(scene).at(1.0).value;
  std::vector<Vec> errors;
  for (int steps = coarsest; steps <= 64 * coarsest; steps *= 2) {
    const auto path = scheme.solve(scene.problem, Grid{1.0, steps}, {.output_times = {1.0}});
    errors.emplace_back(columns_at(scene.outputs, 1.0, path.y.col(0)) - exact);
  }
  const auto later = powers_without_start_weights(GetParam());
  for (const std::size_t k : {0, 1}) take_out(1.0 + later[k], errors);
  const double theory = scheme.expected_rate(scene.problem, scene.smoothness, 1.0, Norm::end);
  EXPECT_DOUBLE_EQ(theory, rate);
  expect_rate(errors, 1.0 / coarsest, theory);
}

// The first steps, which are solved together, with step size h -> 0: the leading error is h^(g+r), r the
// first power without a starting weight. This is the rate in the maximum norm where it is below the rate of
// the rule. The next two powers are eliminated.
TEST_P(MultistepFirstSteps, HaveTheRateOfTheory) {
  const auto& [name, id, scene, orders, rate, coarsest] = GetParam();
  const Scheme& scheme = *find_scheme(id);
  const auto reference = reference_of(scene);
  const double theory = scheme.expected_rate(scene.problem, scene.smoothness, 1.0, Norm::first_step);
  const int steps = static_cast<int>(scheme.starting_powers(scene.problem).size()) - 1;
  std::vector<double> later;
  for (const double order : orders) {
    for (const double r : powers_without_start_weights(GetParam())) {
      if (order + r > theory + power_separation) later.push_back(order + r);
    }
  }
  std::ranges::sort(later);
  const double longest = std::pow(10.0, -4.0 / theory);
  std::vector<Matrix> errors;
  for (int k = 0; k < 7; ++k) {
    Scene first = scene;
    first.problem.end = steps * std::ldexp(longest, -k);
    const auto path = scheme.solve(first.problem, Grid{first.problem.end, steps}, {});
    Matrix error(std::ssize(scene.outputs.names), steps);
    for (Eigen::Index c = 1; c <= steps; ++c) {
      const double t = path.time(c);
      error.col(c - 1) = columns_at(scene.outputs, t, path.y.col(c)) - reference.at(t).value;
    }
    errors.push_back(error);
  }
  for (const std::size_t k : {0, 1}) take_out(later[k], errors);
  expect_rate(errors, longest, theory);
}

// The largest error over all steps, sampled more sparsely at later steps, of rules of rate 2 whose first
// steps have a smaller error.
TEST_P(MultistepRate, InTheMaximumNormIsThatOfTheory) {
  const auto& [name, id, scene, orders, rate, coarsest] = GetParam();
  const Scheme& scheme = *find_scheme(id);
  const double theory = scheme.expected_rate(scene.problem, scene.smoothness, 1.0, Norm::maximum);
  if (theory < 2.0 || rate > 2.0) return;
  const auto reference = reference_of(scene);
  std::vector<Vec> errors;
  for (int steps = 16 * coarsest; steps <= 128 * coarsest; steps *= 2) {
    const auto path = scheme.solve(scene.problem, Grid{1.0, steps}, {});
    Vec largest = Vec::Zero(std::ssize(scene.outputs.names));
    for (Eigen::Index c = 1; c <= steps; c += 1 + c / 32) {
      const double t = path.time(c);
      const Vec error = columns_at(scene.outputs, t, path.y.col(c)) - reference.at(t).value;
      largest = largest.cwiseMax(error.cwiseAbs());
    }
    errors.push_back(largest);
  }
  expect_rate(errors, 1.0 / (16 * coarsest), theory);
}

INSTANTIATE_TEST_SUITE_P(, MultistepRate, testing::ValuesIn(multistep_cases()), name_of_param);
INSTANTIATE_TEST_SUITE_P(, MultistepFirstSteps, testing::ValuesIn(cases_of_first_steps()), name_of_param);

struct HighRule {
  const char* id;
  double rate;
};

// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest looks for this name.
void PrintTo(const HighRule& rule, std::ostream* out) { *out << rule.id; }

// Rules whose error reaches rounding before the powers without starting weights dominate it.
class HighMultistepRate : public testing::TestWithParam<HighRule> {
 protected:
  // Expects the rate of the rule for the largest error of all columns at the end.
  static void expect_own_rate(const Scene& scene, const Vec& exact, const std::vector<int>& all_steps) {
    const auto [id, rate] = GetParam();
    const double end = scene.problem.end;
    std::vector<ErrorSample> points;
    std::string rows;
    for (const int steps : all_steps) {
      const auto path = solve(id, scene.problem, steps, {.output_times = {end}});
      const Vec error = columns_at(scene.outputs, end, path.y.col(0)) - exact;
      points.push_back({end / steps, error.cwiseAbs().maxCoeff()});
      rows += fmt::format("{} {:.3e}\n", steps, points.back().error);
    }
    const Fit fit = fit_rate(points);
    ASSERT_GE(fit.points, 3U) << rows;
    EXPECT_NEAR(fit.slope, rate, 0.1) << rows;
  }
};

// D^g y = Gamma(p+1)/Gamma(p+1-g) t^(p-g) + t^p - y has the solution t^p. With p = g + rate + 3 there is no
// error from powers without starting weights.
TEST_P(HighMultistepRate, IsThatOfTheRuleForSmoothSolutions) {
  for (const double g : {0.2, 0.5, 0.8, 1.3, 1.7}) {
    SCOPED_TRACE(g);
    const double p = g + GetParam().rate + 3.0;
    const Scene scene = scene_of("power", {{"gamma", g}, {"p", p}});
    expect_own_rate(scene, Vec::Constant(1, std::pow(scene.problem.end, p)), {160, 200, 250, 320});
  }
}

// A chain of links of order 1/2; the solution has all powers of t^(1/2).
TEST_P(HighMultistepRate, IsThatOfTheRuleForAChain) {
  const Scene scene = scene_of("damped_oscillator");
  expect_own_rate(scene, reference_of(scene).at(scene.problem.end).value, {226, 320, 452, 640});
}

INSTANTIATE_TEST_SUITE_P(, HighMultistepRate,
                         testing::Values(HighRule{"bdf4", 4.0}, HighRule{"bdf5", 5.0}, HighRule{"bdf6", 6.0}),
                         [](const auto& test) { return test.param.id; });

}  // namespace
}  // namespace fde::bench
