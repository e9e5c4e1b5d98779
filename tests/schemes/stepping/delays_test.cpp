// SPDX-License-Identifier: MIT
// Problems whose right-hand side contains earlier values of y, in every scheme.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/schemes/problem/stored_results.hpp"
#include "fdebench/schemes/stepping/with_delays.hpp"
#include "support/adaptive_schemes.hpp"
#include "support/scheme_test.hpp"

namespace fde::bench {
namespace {

// D^g y = -y(t - 1), where y is `before` for t < 0 and 1 at t = 0.
Problem delayed_decay(double g, double before, double end = 3.0) {
  return {.components = {{g, {1.0}}},
          .end = end,
          .delays = {.lags = {1.0},
                     .before = [before](double, Out y) { y[0] = before; },
                     .rhs =
                         [](double t, In, const Past& past, Out f) {
                           past(t - 1.0, f);
                           f[0] = -f[0];
                         },
                     .jacobian = [](double, In, const Past&, OutMatrix j) { j.setZero(); }}};
}

// Its solution by the method of steps, one power of t - k after another:
//   before = 1: sum_k (-1)^k (t - k + 1)_+^(k g) / Gamma(k g + 1),
//   before = 0: the same with t - k in place of t - k + 1.
double solution_of_delayed_decay(double g, double before, double t) {
  double sum = 0.0;
  for (int k = 0; t - k + before >= 0.0; ++k) {
    const double since = k == 0 ? 1.0 : t - k + before;
    sum += (k % 2 == 0 ? 1.0 : -1.0) * std::pow(since, k * g) / std::tgamma(k * g + 1);
  }
  return sum;
}

double error_at_end(const Scheme& scheme, const Problem& problem, int steps, double exact) {
  const auto path = scheme.solve(problem, Grid{problem.end, steps}, {.output_times = {problem.end}});
  EXPECT_EQ(path.status, SolveStatus::finished) << scheme.id;
  return std::abs(path.y(0, path.y.cols() - 1) - exact);
}

// y = 1 + t^3 solves D^g y = D^g t^3 - 3 (y - 1 - t^3) + sum_k c_k (y(t - tau_k) - 1 - (t - tau_k)^3).
Problem problem_with_cube_as_solution(double g) {
  Problem problem{.components = {{g, std::vector<double>(initial_count(g), 0.0)}}, .end = 4.0};
  problem.components[0].initial[0] = 1.0;
  const auto cube = [](double t) { return 1.0 + t * t * t; };
  const auto derivative = [g](double t) { return 6.0 * std::pow(t, 3.0 - g) / std::tgamma(4.0 - g); };
  const std::vector<double> lags{0.3, 0.75, 2.0}, coefficients{0.5, -0.7, 0.4};
  problem.delays = {.lags = lags,
                    .before = [cube](double t, Out y) { y[0] = cube(t); },
                    .rhs =
                        [=](double t, In y, const Past& past, Out f) {
                          Vec earlier(1);
                          f[0] = derivative(t) - 3.0 * (y[0] - cube(t));
                          for (std::size_t k = 0; k < lags.size(); ++k) {
                            past(t - lags[k], earlier);
                            f[0] += coefficients[k] * (earlier[0] - cube(t - lags[k]));
                          }
                        },
                    .jacobian = [](double, In, const Past&, OutMatrix j) { j(0, 0) = -3.0; }};
  return problem;
}

class DelaysOverAGrid : public SchemeTest {};

// The solution has a term (t - k)^(k g + g) from each time k on, as from 0 on. A rule makes the error of the
// first of them at the end, whatever its order for smooth solutions: h^(1+g) where it integrates f, h where
// it differentiates y.
TEST_P(DelaysOverAGrid, KeepTheRateOfTheTermAtTheStart) {
  constexpr double g = 0.6;
  const double of_steps = GetParam()->id == "commensurate_adams_pc" ? 0.2 : g;
  const bool differentiates = GetParam()->id.starts_with("l") || GetParam()->id == "grunwald_letnikov";
  const double theory = differentiates ? 1.0 : 1.0 + of_steps;
  const Problem problem = delayed_decay(g, 1.0);
  const double exact = solution_of_delayed_decay(g, 1.0, problem.end);
  const double coarse = error_at_end(*GetParam(), problem, 9600, exact),
               fine = error_at_end(*GetParam(), problem, 19200, exact);
  EXPECT_NEAR(std::log2(coarse / fine), theory, 0.12) << coarse << ' ' << fine;
}

// A value between two steps is interpolated: the lag is no multiple of the step.
TEST_P(DelaysOverAGrid, AreInterpolatedToTheOrderOfTheRule) {
  // Without delays the rate of the commensurate expansion is no better with as many steps: order 0.2 + 0.2.
  const double least = GetParam()->id == "commensurate_adams_pc" ? 0.2 : 0.9;
  for (const double g : {0.4, 1.0, 1.6}) {
    const Problem problem = problem_with_cube_as_solution(g);
    const double coarse = error_at_end(*GetParam(), problem, 397, 65.0),
                 fine = error_at_end(*GetParam(), problem, 794, 65.0);
    constexpr double rounding = 1e-11;
    EXPECT_GT(std::log2(std::max(coarse, rounding) / std::max(fine, rounding / 4.0)), least)
        << g << ' ' << coarse << ' ' << fine;
    EXPECT_LT(fine, 0.02) << g;
  }
}

// y(0) = 1 and y = 0 before: f jumps at t = 1, which is a grid time.
TEST_P(DelaysOverAGrid, MayMakeTheRightHandSideJump) {
  const Problem problem = delayed_decay(1.0, 0.0, 4.5);
  const double exact = solution_of_delayed_decay(1.0, 0.0, problem.end);
  const double rate = std::log2(error_at_end(*GetParam(), problem, 450, exact) /
                                error_at_end(*GetParam(), problem, 900, exact));
  EXPECT_GT(rate, 0.95);
}

TEST_P(DelaysOverAGrid, AreNotShorterThanAStep) {
  const Problem problem = delayed_decay(0.6, 1.0);
  const auto reason = unsupported_reason(*GetParam(), problem, Grid{problem.end, 2});
  ASSERT_TRUE(reason);
  EXPECT_THAT(*reason, testing::HasSubstr("in the shortest delay, 1, and not steps of 1.5"));
}

std::vector<const Scheme*> stepping_schemes() {
  auto some = all_schemes();
  std::erase_if(some, [](const Scheme* scheme) {
    return scheme->capabilities.is_adaptive() || scheme->capabilities.discretises_equations;
  });
  return some;
}
INSTANTIATE_TEST_SUITE_P(, DelaysOverAGrid, testing::ValuesIn(stepping_schemes()), id_of_param);

class DelaysWithATolerance : public testing::TestWithParam<const Scheme*> {
 protected:
  static Trajectory run(const Problem& problem, double tolerance) {
    auto path = GetParam()->solve(problem, Tolerance{tolerance, tolerance}, {});
    EXPECT_EQ(path.status, SolveStatus::finished);
    return path;
  }
};

// At all times of the run, and between them: f is constant up to t = 1, so that the first step may be that
// long, and y is no polynomial on it.
TEST_P(DelaysWithATolerance, KeepIt) {
  for (const double g : {0.3, 0.6, 1.0}) {
    for (const double before : {0.0, 1.0}) {
      const auto path = run(delayed_decay(g, before), 1e-7);
      const auto exact = [&](double t) { return solution_of_delayed_decay(g, before, t); };
      expect_row(path, 0, exact, 3e-7, 100);
      for (const double t : {1e-4, 0.1, 0.99, 1.0001, 2.5})
        EXPECT_NEAR(path.dense_output(t)[0], exact(t), 1e-6) << g << ' ' << before << ' ' << t;
    }
  }
}

TEST_P(DelaysWithATolerance, MayBeMany) {
  const auto exact = [](double t) { return 1.0 + t * t * t; };
  for (const double g : {0.4, 1.0, 1.6})
    expect_row(run(problem_with_cube_as_solution(g), 1e-5), 0, exact, 1e-3, 100);
}

INSTANTIATE_TEST_SUITE_P(, DelaysWithATolerance, testing::ValuesIn(adaptive_schemes()), id_of_param);

// Hutchinson's equation D^g y = y (1 - y(t - tau)): a scheme on panels and one on a grid, which share neither
// steps nor interpolation of the past.
TEST(Delays, OfANonlinearEquationAgreeBetweenSchemes) {
  const auto hutchinson = [](double t, In y, const Past& past, Out f) {
    past(t - 0.8, f);
    f[0] = y[0] * (1.0 - f[0]);
  };
  const Problem problem{
      .components = {{0.9, {0.5}}},
      .end = 8.0,
      .delays = {.lags = {0.8}, .before = [](double, Out y) { y[0] = 0.5; }, .rhs = hutchinson}};
  const auto at_end = [&](std::string_view scheme, const Resolution& resolution) {
    const auto path = find_scheme(scheme)->solve(problem, resolution, {.output_times = {problem.end}});
    return path.y(0, 0);
  };
  const double exact = at_end("spectral_collocation", Tolerance{1e-11, 1e-11});
  const double coarse = at_end("product_trapezoidal", Grid{problem.end, 4000}) - exact,
               fine = at_end("product_trapezoidal", Grid{problem.end, 8000}) - exact;
  EXPECT_NEAR(std::log2(coarse / fine), 1.9, 0.1);
  EXPECT_LT(std::abs(fine), 1e-6);
}

TEST(Delays, AreRefusedWhereASchemeHasNone) {
  Problem problem = delayed_decay(0.6, 1.0);
  problem.equations.push_back({0, {1.0, 0.6}, {}, {}, {}});
  EXPECT_EQ(unsupported_reason(*find_scheme("multi_term_pc"), problem, Grid{problem.end, 100}),
            "takes no delays");
  problem.equations.clear();
  problem.components[0].side = Side::right;
  EXPECT_EQ(unsupported_reason(*find_scheme("product_trapezoidal"), problem, Grid{problem.end, 100}),
            "takes no delays in a problem that it solves at all times at once");
}

// Through eight results there is one polynomial of degree 7. |t - 1| is a polynomial on each side of 1.
TEST(StoredResults, ArePolynomialsBetweenBreakingPoints) {
  const auto degree_seven = [](double t) { return std::pow(t - 0.3, 7) - t * t + 2.0; };
  StoredResults smooth(Vec::Constant(1, degree_seven(0.0)), {}), bent(Vec::Constant(1, 1.0), {1.0});
  for (int n = 1; n <= 20; ++n) {
    const double t = 0.1 * n;
    smooth.add(t, Vec::Constant(1, degree_seven(t)));
    bent.add(t, Vec::Constant(1, std::abs(t - 1.0)));
  }
  for (const double t : {0.0, 0.03, 0.55, 0.999, 1.001, 1.3, 1.97, 2.0}) {
    EXPECT_NEAR(smooth.at(t)[0], degree_seven(t), 1e-12) << t;
    EXPECT_NEAR(bent.at(t)[0], std::abs(t - 1.0), 1e-13) << t;
  }
}

}  // namespace
}  // namespace fde::bench
