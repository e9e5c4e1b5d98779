// SPDX-License-Identifier: MIT
// Spectral collocation of problems with right derivatives.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/benchmarks/scenes/two_sided/manufactured_problem.hpp"
#include "fdebench/schemes/rules/two_sided/panel_side.hpp"
#include "support/adaptive_schemes.hpp"
#include "support/testing.hpp"
#include "support/two_sided_problems.hpp"

namespace fde::bench {
namespace {

using testing::HasSubstr;

Trajectory solved(const Problem& problem, double accuracy, const Options& options = {}) {
  return find_scheme("spectral_collocation")->solve(problem, Tolerance{accuracy, accuracy}, options);
}

// J^g t^p = Gamma(p+1)/Gamma(p+g+1) t^(p+g) on panels of any lengths, from both sides, to rounding.
TEST(PanelSides, IntegratePolynomialsExactly) {
  const LegendrePoints points(7);
  const PanelMesh mesh{{1e-9, 1e-3, 0.5, 0.25, 1e-6}, {true, false, false, false, false, true}};
  const double end = mesh.edges()[5];
  for (const Side side : {Side::left, Side::right}) {
    for (const double order : {0.2, 1.0, 1.7}) {
      const Problem problem{.components = {{order, {}, side}}, .end = end};
      const auto rule = std::make_shared<PanelSide>(problem, side, mesh, points);
      const auto times = discretisation_by_panels(problem, mesh, points, rule, rule);
      const Vec& own = side == Side::left ? times->left : times->right;
      for (const double power : {0.0, 1.0, 5.0}) {
        const Rows f = own.array().pow(power).matrix().transpose();
        Rows value = Rows::Zero(1, own.size());
        rule->integrate(f, value);
        const double factor = std::tgamma(power + 1.0) / std::tgamma(power + order + 1.0);
        for (Eigen::Index n = 0; n < own.size(); ++n) {
          const double exact = factor * std::pow(own[n], power + order);
          EXPECT_NEAR(value(0, n), exact, 1e-13 * std::pow(own[n], order) + 1e-300) << order << ' ' << power;
        }
      }
    }
  }
}

// Six rows of orders below, at and above 1; and powers 0.9 and 1.2 of the distances from the ends.
TEST(TwoSidedCollocation, DeliversTheAccuracyOfManufacturedSolutions) {
  for (const auto& made :
       {smooth_two_sided(),
        manufactured_problem({{0.7, 1.2, Side::left}, {0.5, 0.9, Side::right}, {1.4, 1.8, Side::right}},
                             1.0)}) {
    for (const double accuracy : {1e-3, 1e-6, 1e-9, 1e-12}) {
      const auto path = solved(made.problem, accuracy);
      ASSERT_EQ(path.status, SolveStatus::finished) << accuracy;
      EXPECT_EQ(path.last_time, made.problem.end);
      EXPECT_EQ(path.times.front(), 0.0);
      for (const double share : {0.0, 1e-10, 1e-4, 0.1, 0.33, 0.5, 0.8, 0.9999, 1.0 - 1e-10, 1.0}) {
        const double t = share * made.problem.end;
        const Vec exact = made.exact(t), error = (path.dense_output(t) - exact).cwiseAbs();
        EXPECT_LT(error.cwiseQuotient(Vec(1.0 + exact.array().abs())).maxCoeff(), 2.0 * accuracy)
            << accuracy << ' ' << share;
      }
    }
  }
}

// Their solutions are like powers of the distance from both ends; 0.2 is the order of the memory rows.
TEST(TwoSidedCollocation, DeliversTheAccuracyOfScenes) {
  for (const char* scene_id :
       {"two_sided_constraint:motion=given", "fractional_hamilton:motion=given", "fractional_vakonomic",
        "fractional_vakonomic:alpha=0.8", "fractional_extremum:k=2"}) {
    const Scene scene = make_scene(parse_variant(scene_id));
    const auto reference = reference_of(scene);
    for (const double accuracy : {1e-2, 1e-4, 1e-6}) {
      const auto path = solved(scene.problem, accuracy);
      ASSERT_EQ(path.status, SolveStatus::finished) << scene_id << ' ' << accuracy;
      EXPECT_LT(largest_error(scene, reference, path), 3.0 * accuracy) << scene_id << ' ' << accuracy;
    }
  }
}

// What differs is the error of Newton's method.
TEST(TwoSidedCollocation, OfTheMirroredProblemIsMirrored) {
  const ManufacturedProblem made = smooth_two_sided();
  const auto path = solved(made.problem, 1e-6), back = solved(mirrored(made.problem), 1e-6);
  ASSERT_EQ(path.times.size(), back.times.size());
  EXPECT_LT((path.y - back.y.rowwise().reverse()).cwiseAbs().maxCoeff(), 1e-9);
}

// D^0.5 y = step(t - 1) from the left and the right up to t = 3: 2 sqrt(s / pi) behind the jump of either
// side.
TEST(TwoSidedCollocation, StartsAnewAtJumps) {
  const Problem problem{.components = {{0.5, {0.0}}, {0.5, {0.0}, Side::right}},
                        .rhs = [](double t, In, Out f) { f.setConstant(t > 1.0 ? 1.0 : 0.0); },
                        .end = 3.0,
                        .jump_times = {1.0}};
  const auto path = solved(problem, 1e-10);
  ASSERT_EQ(path.status, SolveStatus::finished);
  const auto root = [](double s) { return 2.0 * std::sqrt(std::max(s, 0.0) / std::numbers::pi); };
  for (const double t : {0.3, 1.0 - 1e-6, 1.0, 1.0 + 1e-6, 1.5, 2.9}) {
    const Vec y = path.dense_output(t);
    EXPECT_NEAR(y[0], root(t - 1.0), 1e-10) << t;
    EXPECT_NEAR(y[1], root(3.0 - t) - root(1.0 - t), 1e-10) << t;
  }
}

// y'' = 6 y^2 between y(0) = 4 and y(1) = 1 has the solution 4/(1+t)^2 and another one below 0; tD_1^1 z =
// -y.
TEST(TwoSidedCollocation, FindsOtherSolutionsWhereAsked) {
  const Problem problem{.components = {{1.0, {4.0}}, {1.0, {}}, {1.0, {0.0}, Side::right}},
                        .rhs = [](double, In y, Out f) { f << y[1], 1.5 * y[0] * y[0], y[0]; },
                        .conditions = [](In, In at_end, Out residual) { residual[0] = at_end[0] - 1.0; }};
  const auto path = solved(problem, 1e-10, {.all_solutions = true});
  ASSERT_EQ(path.status, SolveStatus::finished);
  ASSERT_EQ(path.other_solutions.size(), 1U);
  const auto& other = path.other_solutions.front();
  const double a = path.dense_output(0.5)[0], b = other.dense_output(0.5)[0];
  EXPECT_NEAR(std::max(a, b), 4.0 / 2.25, 1e-9);
  EXPECT_LT(std::min(a, b), -5.0);
}

TEST(TwoSidedCollocation, TakesAlgebraicRowsThatDetermineTheirUnknown) {
  const DefinedUnknown problems;
  const auto a = solved(problems.eliminated, 1e-9), b = solved(problems.whole, 1e-9);
  ASSERT_EQ(a.status, SolveStatus::finished);
  ASSERT_EQ(b.status, SolveStatus::finished);
  for (const double t : {0.0, 1e-12, 1e-6, 0.2, 0.7, 0.999, 1.0}) {
    const Vec known = a.dense_output(t), found = b.dense_output(t);
    EXPECT_LT((found.tail(2) - known).cwiseAbs().maxCoeff(), 2e-9) << t;
    EXPECT_NEAR(found[0], DefinedUnknown::z(known), 4e-9) << t;
  }
}

TEST(TwoSidedCollocation, LocatesEvents) {
  const ManufacturedProblem made =
      manufactured_problem({{0.7, 2.0, Side::left}, {0.5, 3.0, Side::right}}, 1.0);
  const auto path =
      solved(made.problem, 1e-10, {.events = {{.value = [](double, In y) { return y[0] - 1.25; }}}});
  ASSERT_EQ(path.events.size(), 1U);
  EXPECT_NEAR(path.events.front().t, 0.5, 1e-9);
}

// y = known + J^0.5 (1e6 + y^2) has no real solution; multipliers and switches are determined in steps.
TEST(TwoSidedCollocation, SaysWhatItDoesNotSolve) {
  const Problem problem{.components = {{0.5, {0.0}}, {0.5, {0.25}, Side::right}},
                        .rhs = [](double, In y, Out f) { f << 1e6 + y[0] * y[0], y[0]; }};
  const auto path = solved(problem, 1e-6);
  EXPECT_EQ(path.status, SolveStatus::not_converged);
  EXPECT_GT(path.residual, 1.0);
  EXPECT_THAT(*unsupported_reason(*find_scheme("spectral_collocation"),
                                  make_scene(parse_variant("fractional_extremum:form=whole")).problem,
                                  Tolerance{1e-6, 1e-6}),
              HasSubstr("multipliers"));
  Problem switching = smooth_two_sided().problem;
  switching.switching_functions = {[](double, In y) { return y[0]; }};
  EXPECT_THAT(*unsupported_reason(*find_scheme("spectral_collocation"), switching, Tolerance{1e-6, 1e-6}),
              HasSubstr("switches"));
}

}  // namespace
}  // namespace fde::bench
