// SPDX-License-Identifier: MIT
// Every (scene, scheme) pair that fits shows the rate that theory gives, two-sided, at a fixed time and in
// the maximum over all steps. Each test is for one norm: a solution that starts like t^g has different
// rates in the two.

#include "fdebench/benchmarks/observers/rate.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "conformance/rate_variants.hpp"
#include "fdebench/schemes/rules/implicit/implicit_rule.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

struct Case {
  const RateScene& variant;
  const Scheme* scheme;
};

// Created once: computing the poles of an exact solution takes a millisecond.
const Scene& make(const RateScene& variant) {
  static std::map<std::string, Scene> made;
  auto found = made.find(variant.name);
  if (found == made.end()) {
    found = made.emplace(variant.name, scene_of(variant.scene, variant.values)).first;
    found->second.problem.end = variant.end;
  }
  return found->second;
}

double expected(const Case& c, Norm norm) {
  const Scene& scene = make(c.variant);
  return c.scheme->expected_rate(scene.problem, scene.smoothness, c.variant.grading, norm);
}

bool first_step_governs_the_maximum(const Case& c) {
  return expected(c, Norm::first_step) < expected(c, Norm::end);
}
bool the_rest(const Case& c) {
  return !first_step_governs_the_maximum(c) || expected(c, Norm::maximum) < expected(c, Norm::first_step);
}

// Calls check for every one of these schemes that takes the scene on this grid. Excepted are, on graded
// grids, the commensurate expansion, which is adams_pc again with powers of h too close to separate, and
// schemes with starting weights, whose errors are at rounding with so many steps (rates:
// tests/schemes/rules/start_weights).
void for_each_of(const std::vector<const Scheme*>& some, const RateScene& variant,
                 const std::function<void(const Case&)>& check) {
  const Scene& scene = make(variant);
  for (const auto* scheme : some) {
    if (scheme->starting_powers) continue;
    if (unsupported_reason(*scheme, scene.problem, Grid{variant.end, 256, variant.grading})) continue;
    if (variant.grading != 1.0 && !scheme->expansion_of.empty()) continue;
    // Its unmeasured rows have errors h and -h, which cancel in the output columns.
    const bool of_parabolas = scheme->id == "l1_2" || scheme->id == "l2_1_sigma";
    if (of_parabolas && variant.name == "nonlinear_fractional_oscillator_integrated") continue;
    SCOPED_TRACE(scheme->id);
    check({variant, scheme});
  }
}
void for_each_scheme(const RateScene& variant, const std::function<void(const Case&)>& check) {
  for_each_of(grid_schemes(), variant, check);
}

// Errors y - reference of the scene's columns with N steps: at the end, or at every step.
Rows errors(const Case& c, const Scene& scene, MemoizedReference& reference, int steps, Norm norm) {
  const Grid grid{scene.problem.end, steps, c.variant.grading};
  Options options;
  if (norm == Norm::end) options.output_times = {grid.end};
  const auto path = c.scheme->solve(scene.problem, grid, options);
  EXPECT_EQ(path.status, SolveStatus::finished);
  return columns_of(scene.outputs, path) - reference.at(path.times);
}

void expect_rate(const std::vector<ErrorSample>& points, double theory) {
  std::string rows;
  for (const auto& [h, error] : points) rows += fmt::format("h = {:.3e}: error {:.3e}\n", h, error);
  const Fit fit = fit_rate(points);
  ASSERT_GE(fit.points, 4U) << rows;
  EXPECT_NEAR(fit.slope, theory, 0.1) << rows;
  EXPECT_GT(fit.correlation, 0.999) << rows;
}

// Predictor-corrector errors have the powers 1 + g, 1 + 2g, ..., 2 of h. Where the first are close to each
// other, or the first has a small factor, no affordable step size shows the first alone. The later powers are
// known from theory, so they are eliminated: e(h) - 2^q e(h/2) has no h^q.
std::vector<double> later_powers(const Case& c, Norm norm) {
  struct Close {
    std::string_view variant;
    std::vector<std::string_view> schemes;
    std::vector<double> powers;
    bool at_the_end_only = false;
  };
  static const std::vector<Close> table{
      {"relaxation_2", {"adams_pc", "decoupled_multi_order", "commensurate_adams_pc"}, {1.4, 1.6, 1.8}},
      {"relaxation_pair_2", {"adams_pc", "decoupled_multi_order", "commensurate_adams_pc"}, {1.4, 1.6, 1.8}},
      {"diethelm_2", {"adams_pc", "decoupled_multi_order", "commensurate_adams_pc"}, {1.4, 1.6, 1.8}},
      {"diethelm_5", {"adams_pc", "decoupled_multi_order", "commensurate_adams_pc"}, {2.0}},
      {"diethelm_8", {"adams_pc", "decoupled_multi_order"}, {2.0}},
      {"diethelm_8", {"l1"}, {1.2}},
      {"fractional_oscillator_13", {"l1_2", "l2_1_sigma"}, {1.3}},
      {"fractional_oscillator_17", {"l1_2", "l2_1_sigma"}, {1.7}},
      {"power_4__graded_15", {"l2_1_sigma"}, {2.0, 2.55}},
      {"power_6__graded_15", {"l2_1_sigma"}, {2.0}},
      {"relaxation_4__graded_25", {"l2_1_sigma"}, {2.5}},
      {"relaxation_6__graded_25", {"l2_1_sigma"}, {2.4}},
      {"relaxation_8__graded_25", {"l2_1_sigma"}, {2.4}, true},
      {"relaxation_15__graded_15", {"l1_2"}, {2.0, 2.25}},
      {"relaxation_15__graded_25", {"l1_2"}, {2.5}},
      {"bagley_torvik_13", {"multi_term_trapezoidal", "multi_term_pc"}, {2.0}, true},
      {"pendulum_125_75", {"multi_term_trapezoidal", "multi_term_pc"}, {2.0}},
      {"power_17", {"decoupled_multi_order"}, {2.0, 2.7}},
      {"fractional_oscillator_13", {"adams_pc"}, {2.3}},
      {"fractional_constraint_2d_2_integrated", {"product_trapezoidal"}, {2.0}},
      {"fractional_constraint_2d_15_integrated", {"product_trapezoidal"}, {2.5}},
      {"fractional_constraint_2d_3_stabilised", {"product_trapezoidal"}, {1.7, 2.0}},
      {"fractional_constraint_1d_250", {"adams_pc", "decoupled_multi_order"}, {2.0}},
      {"fractional_constraint_1d_275", {"adams_pc", "decoupled_multi_order"}, {2.0}},
      {"fractional_constraint_nonlinear_acceleration", {"adams_pc", "decoupled_multi_order"}, {1.4, 1.6}},
      {"fractional_constraint_nonlinear_stabilised", {"adams_pc", "decoupled_multi_order"}, {1.4, 1.6}},
      {"fractional_constraint_nonlinear_stabilised", {"product_trapezoidal"}, {1.6, 1.8}},
      {"nonlinear_fractional_oscillator_integrated", {"product_trapezoidal"}, {2.5}},
      {"nonlinear_fractional_oscillator_reduced", {"l1"}, {1.5}},
      {"nonlinear_fractional_oscillator_reduced", {"multi_term_trapezoidal", "multi_term_pc"}, {2.5}},
      {"nonlinear_fractional_oscillator_multiplier", {"l1"}, {1.5}},
      {"relaxation_15__graded_15", {"l1"}, {1.5}},
      {"relaxation_15__graded_25", {"adams_pc"}, {2.5}},
      {"relaxation_15__graded_40", {"adams_pc"}, {2.5}},
      {"relaxation_15__graded_40", {"l1"}, {1.5}},
  };
  for (const auto& [variant, concerned, powers, at_the_end_only] : table) {
    if (at_the_end_only && norm != Norm::end) continue;
    if (variant == c.variant.name && std::ranges::find(concerned, c.scheme->id) != concerned.end())
      return powers;
  }
  return {};
}

// The largest error at the end, or over all steps, of 256 ... 4096 steps; finer by a level for each power
// eliminated.
std::vector<ErrorSample> error_points(const Case& c, Norm norm) {
  const Scene& scene = make(c.variant);
  MemoizedReference reference(scene);
  const auto powers = later_powers(c, norm);
  constexpr int coarsest = 256, levels = 5;
  std::vector<Rows> by_level;
  for (int level = 0; level < levels + static_cast<int>(powers.size()); ++level) {
    const int steps = coarsest << level;
    const Rows all = errors(c, scene, reference, steps, norm);
    // Errors of several levels are combined at the times they share.
    const bool combined = norm == Norm::maximum && !powers.empty();
    by_level.push_back(combined ? Rows(all(Eigen::all, Eigen::seq(0, steps, steps / coarsest))) : all);
  }
  for (const double q : powers) {
    for (std::size_t level = 0; level + 1 < by_level.size(); ++level) {
      by_level[level] -= std::pow(2.0, q) * by_level[level + 1];
    }
    by_level.pop_back();
  }
  std::vector<ErrorSample> points;
  for (int level = 0; level < levels; ++level) {
    points.push_back({scene.problem.end / (coarsest << level),
                      by_level[static_cast<std::size_t>(level)].cwiseAbs().maxCoeff()});
  }
  return points;
}

class EndRate : public testing::TestWithParam<RateScene> {};

TEST_P(EndRate, MatchesTheory) {
  for_each_scheme(GetParam(),
                  [](const Case& c) { expect_rate(error_points(c, Norm::end), expected(c, Norm::end)); });
}

INSTANTIATE_TEST_SUITE_P(, EndRate, testing::ValuesIn(variants()), name_of_variant);
INSTANTIATE_TEST_SUITE_P(OnGradedGrids, EndRate, testing::ValuesIn(graded_variants()), name_of_variant);

// Where the solution starts like t^g, the error of the first step is the largest: one step of length h, h ->
// 0.
void expect_first_step_rate(const Case& c) {
  const double theory = expected(c, Norm::first_step);
  const Scene& scene = make(c.variant);
  MemoizedReference reference(scene);
  std::vector<ErrorSample> points;
  const double shortest = std::min(9.0 / theory, 16.0), longest = std::min(5.0 / theory, 10.0);  // -log10 h
  for (int k = 0; k < 5; ++k) {
    Scene first = scene;
    first.problem.end = std::pow(10.0, -(longest + k * (shortest - longest) / 4));
    const Grid grid{first.problem.end, 1};
    const auto path = c.scheme->solve(first.problem, grid, {});
    points.push_back(
        {grid.end, (columns_of(scene.outputs, path) - reference.at(path.times)).cwiseAbs().maxCoeff()});
  }
  expect_rate(points, theory);
}

class FirstStepRate : public testing::TestWithParam<RateScene> {};

TEST_P(FirstStepRate, MatchesTheory) {
  for_each_scheme(GetParam(), [](const Case& c) {
    if (first_step_governs_the_maximum(c)) expect_first_step_rate(c);
  });
}

INSTANTIATE_TEST_SUITE_P(, FirstStepRate, testing::ValuesIn(variants()), name_of_variant);

// In other cases the maximum over all steps falls like the error at the end, or like the error next to a
// jump.
class MaximumRate : public testing::TestWithParam<RateScene> {};

// After a jump the predictor and the corrector have errors h^g of opposite signs, the powers 1 + g, 1 + 2g,
// ... besides: no affordable step size shows the first alone.
bool is_corrected_after_a_jump(const Case& c) {
  const auto& problem = make(c.variant).problem;
  return !problem.jump_times.empty() && problem.jump_times.front() < problem.end &&
         (c.scheme->id == "adams_pc" || c.scheme->id == "decoupled_multi_order");
}

TEST_P(MaximumRate, MatchesTheory) {
  for_each_scheme(GetParam(), [](const Case& c) {
    if (the_rest(c) && !is_corrected_after_a_jump(c))
      expect_rate(error_points(c, Norm::maximum), expected(c, Norm::maximum));
  });
}

INSTANTIATE_TEST_SUITE_P(, MaximumRate, testing::ValuesIn(variants()), name_of_variant);
INSTANTIATE_TEST_SUITE_P(OnGradedGrids, MaximumRate, testing::ValuesIn(graded_variants()), name_of_variant);

class EquationRate : public testing::TestWithParam<RateScene> {};

TEST_P(EquationRate, MatchesTheoryAtTheEnd) {
  for_each_of(equation_schemes(), GetParam(),
              [](const Case& c) { expect_rate(error_points(c, Norm::end), expected(c, Norm::end)); });
}

TEST_P(EquationRate, MatchesTheoryAtTheFirstStep) {
  for_each_of(equation_schemes(), GetParam(), [](const Case& c) {
    if (c.variant.grading == 1.0 && first_step_governs_the_maximum(c)) expect_first_step_rate(c);
  });
}

INSTANTIATE_TEST_SUITE_P(, EquationRate, testing::ValuesIn(multi_term_variants()), name_of_variant);

// f = 1.5 sqrt(pi)/2 t + t^1.5 - y starts like t: the corrector is exact for it, the error of the prediction
// is h^(1+g).
TEST(FirstStep, OfThePredictorCorrectorForALinearStart) {
  const RateScene linear{"power_linear", "power", {{"gamma", 0.5}, {"p", 1.5}}, 1.0};
  const Case pair{linear, find_scheme("adams_pc")};
  std::vector<ErrorSample> points;
  for (double h = 1e-2; h > 1e-5; h /= 4) {
    const auto path = pair.scheme->solve(make(pair.variant).problem, Grid{h, 1}, {});
    points.push_back({h, std::abs(path.y(0, 1) - std::pow(h, 1.5))});
  }
  EXPECT_EQ(expected(pair, Norm::first_step), 2.0);
  expect_rate(points, 2.0);
}

// The trapezoidal weight of the last value off by one percent: the method still converges, but like h^g.
TEST(AWrongWeight, IsCaughtByTheRate) {
  Scheme wrong = *find_scheme("product_trapezoidal");
  wrong.solve = on_grid([](const Problem& problem, const Grid& grid, const Options& options) {
    Vec last = Vec::Zero(problem.size());
    return solve_implicit(problem, grid, options,
                          {.tables = weight_tables(problem, families::trapezoid),
                           .known =
                               [&](double t, In convolved, In, In kappa, Out known) {
                                 known =
                                     taylor_part(problem, t) + kappa.cwiseProduct(convolved + 0.01 * last);
                               },
                           .sample =
                               [&](double t, In y, In, Out sample) {
                                 problem.rhs(t, y, sample);
                                 last = sample;
                               }});
  });
  const RateScene smooth{"power_5", "power", {{"gamma", 0.5}, {"p", 2.5}}, 1.0};
  const Fit right = fit_rate(error_points({smooth, find_scheme("product_trapezoidal")}, Norm::end));
  const Fit caught = fit_rate(error_points({smooth, &wrong}, Norm::end));
  EXPECT_NEAR(right.slope, 2.0, 0.1);
  EXPECT_NEAR(caught.slope, 0.5, 0.1);
}

}  // namespace
}  // namespace fde::bench
