// SPDX-License-Identifier: MIT
// lambda and the power of the reactions, in every formulation, compared with exact values.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fdebench/benchmarks/observers/drift.hpp"
#include "fdebench/benchmarks/observers/reaction_path.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// Multipliers and power at the end of a run.
Vec reactions_at_end(const Scene& scene, const Grid& grid, std::string_view scheme = "product_trapezoidal") {
  const auto times = with_neighbour_times(scene.reactions, grid, {grid.end}, grid.end);
  const auto path = solve(scheme, scene.problem, grid, {.output_times = times});
  return ReactionPath(scene, grid, path).at(path.y.cols() - 1, columns_of(scene.outputs, path).rightCols(1));
}

// Laplace transforms inverted in 30 digits by Talbot's contour (mpmath).
TEST(Reactions, OfThePlaneAreThoseOfItsTransform) {
  struct KnownCase {
    double alpha, t, lambda, power;
  };
  for (const auto& [alpha, t, lambda, power] :
       {KnownCase{0.5, 1.0, 0.29453781383463669, 0.040077043122332318},
        KnownCase{0.5, 10.0, 0.83659602775236536, -0.26406892789246862},
        KnownCase{0.8, 1.0, 0.31201331035038933, 0.073805536036409298}}) {
    const Scene scene = scene_of("fractional_constraint_2d", {{"alpha", alpha}});
    const Vec columns = scene.reference.at(t).value, exact = scene.reactions.exact.at(t).value;
    EXPECT_NEAR(exact[0], lambda, 1e-14);
    EXPECT_NEAR(with_reaction_power(scene, t, columns, exact)[1], power, 1e-14);
  }
}

struct Form {
  std::string scene;
  ParameterValues values;
};

// Scenes with exact reactions; those with memory are below, at and above order 1, with and without a singular
// start.
std::vector<Form> forms() {
  std::vector<Form> all;
  const auto add = [&](const std::string& scene, const ParameterValues& values,
                       const std::vector<std::string>& formulations) {
    for (const auto& formulation : formulations) {
      all.push_back({scene, values});
      all.back().values["formulation"] = formulation;
    }
  };
  const std::vector<std::string> every{"integrated", "acceleration", "stabilised", "multiplier"};
  for (const auto* scene : {"nonholonomic_particle", "knife_edge", "rolling_disc", "loxodrome"})
    add(scene, {}, every);
  add("rolling_disc", {{"pull", 0.5}}, every);
  add("fractional_constraint_2d", {{"alpha", 0.3}}, every);
  add("fractional_constraint_2d", {{"alpha", 1.0}}, every);
  for (const double alpha : {0.5, 0.8}) add("fractional_constraint_2d", {{"alpha", alpha}}, {"integrated"});
  for (const double constant : {0.0, 0.3}) {
    add("fractional_constraint_2d", {{"alpha", 1.5}, {"a2", 0.5}, {"b1", 0.8}, {"b2", 0.3}, {"C0", constant}},
        {"integrated", "multiplier"});
  }
  for (const double alpha : {0.5, 1.5, 2.5}) all.push_back({"fractional_constraint_1d", {{"alpha", alpha}}});
  all.push_back({"fractional_constraint_1d", {{"alpha", 1.5}, {"C0", 0.0}}});
  return all;
}

Vec exact_reactions(const Scene& scene, double t) {
  return exact_reactions(scene, t, scene.reference.at(t).value);
}

TEST(Reactions, OfEveryFormulationApproachTheExactOnes) {
  for (const auto& [id, values] : forms()) {
    Scene scene = scene_of(id, values);
    scene.problem.end = 2.0;
    const Vec exact = exact_reactions(scene, 2.0);
    const auto error = [&](int steps) {
      return (reactions_at_end(scene, {2.0, steps}) - exact).cwiseAbs().maxCoeff();
    };
    const double fine = error(2048);
    EXPECT_LT(fine, 2e-3) << scene.name;
    EXPECT_LT(fine, std::max(0.7 * error(512), 1e-9)) << scene.name;
  }
}

// With an adaptive step size there are no steps beside an output time: rates are computed from values around
// it.
TEST(Reactions, OfRunsToAnAccuracyAreTheExactOnes) {
  const std::vector<double> asked{1e-5, 0.01, 1.0, 1.9999, 2.0};
  for (const auto& [id, values] : forms()) {
    Scene scene = scene_of(id, values);
    scene.problem.end = 2.0;
    for (const auto* scheme : {"spectral_collocation", "radau_exponentials"}) {
      const Tolerance accuracy{.rtol = 1e-8, .atol = 1e-8};
      if (unsupported_reason(*find_scheme(scheme), scene.problem, accuracy)) continue;
      const auto times = with_neighbour_times(scene.reactions, std::nullopt, asked, 2.0);
      const auto path = solve(scheme, scene.problem, accuracy, {.output_times = times});
      const ReactionPath reactions(scene, std::nullopt, path);
      const Rows columns = columns_of(scene.outputs, path);
      for (std::size_t c = 0; c < times.size(); ++c) {
        if (std::ranges::find(asked, times[c]) == asked.end()) continue;
        const auto column = static_cast<Eigen::Index>(c);
        const Vec exact = exact_reactions(scene, times[c]), found = reactions.at(column, columns.col(column));
        EXPECT_LT((found - exact).cwiseAbs().maxCoeff(), 1e-4 * (1.0 + exact.cwiseAbs().maxCoeff()))
            << scene.name << ' ' << scheme << ", t = " << times[c];
      }
    }
  }
}

// Knife edge: lambda = -2 g sin(theta) sin(omega t), and the reaction does no work.
TEST(Reactions, OfTheKnifeEdgeHaveAClosedForm) {
  const Scene scene = scene_of("knife_edge");
  for (const double t : {0.0, 1.0, 7.5}) {
    const Vec at = exact_reactions(scene, t);
    EXPECT_NEAR(at[0], -2.0 * 9.81 * std::sin(0.5) * std::sin(t), 1e-13) << t;
    EXPECT_NEAR(at[1], 0.0, 1e-13) << t;
  }
}

// lambda starts like -(b.v(0))/|a|^2 t^-alpha/Gamma(1-alpha): unbounded at 0, and of the right size from t_1
// on.
TEST(Reactions, BeginWithTheFirstStepWhereTheyAreUnbounded) {
  Scene scene = scene_of("fractional_constraint_2d");
  ASSERT_FALSE(scene.reactions.initial_multipliers);
  for (const double grading : {1.0, 2.0}) {
    const Grid grid{10.0, 4096, grading};
    const auto path = solve("product_trapezoidal", scene.problem, grid);
    const ReactionPath reactions(scene, grid, path);
    EXPECT_TRUE(std::isnan(reactions.at(0, columns_at(scene.outputs, 0.0, path.y.col(0)))[0]));
    for (const int n : {1, 2, 3, 10, 100}) {
      const double t = grid.time(n), exact = scene.reactions.exact.at(t).value[0];
      const double computed = reactions.at(n, columns_at(scene.outputs, t, path.y.col(n)))[0];
      EXPECT_NEAR(computed, exact, 0.2 * std::abs(exact)) << n << ' ' << grading;
    }
  }
  const Scene regular = scene_of("fractional_constraint_2d", {{"v1", 0.0}, {"v2", 0.0}});
  ASSERT_TRUE(regular.reactions.initial_multipliers);
  EXPECT_NEAR((*regular.reactions.initial_multipliers)[0], regular.reactions.exact.at(1e-9).value[0], 1e-5);
}

// With c = -a (b.v(0))/|a|^2 and v' = -grad u + a lambda, after subtraction of the leading singular term,
//   lambda |a|^2 - a.grad u + b.v(0) t^-alpha/Gamma(1-alpha) starts like t^(1 - 2 alpha),
//   b.(D^alpha v - c t^(1-2 alpha)/Gamma(2-2 alpha)) starts like t^(2 - 3 alpha).
// The former is -b.D^alpha v.
TEST(ReactionStarts, HaveThePowersThatTheAccelerationFormIsRefusedFor) {
  const double alpha = 0.6, bv = 5.0 * 0.4 - 3.0 * 0.2, ab = 11.0, aa = 5.0;
  const Scene scene = scene_of("fractional_constraint_2d", {{"alpha", alpha}, {"b1", 5.0}, {"b2", 3.0}});
  const auto of_acceleration = [&](double t) {
    const Vec q = scene.reference.at(t).value;
    return aa * scene.reactions.exact.at(t).value[0] - q[0] - 4.0 * q[1] +
           bv * std::pow(t, -alpha) / std::tgamma(1.0 - alpha);
  };
  const auto of_memory = [&](double t) {
    return -of_acceleration(t) +
           ab * bv / aa * std::pow(t, 1.0 - 2.0 * alpha) / std::tgamma(2.0 - 2.0 * alpha);
  };
  const double t = 1e-12, ratio = 1e3;
  const auto power = [&](const auto& of) { return std::log(of(ratio * t) / of(t)) / std::log(ratio); };
  EXPECT_NEAR(power(of_acceleration), 1.0 - 2.0 * alpha, 0.02);
  EXPECT_NEAR(power(of_memory), 2.0 - 3.0 * alpha, 0.02);
}

// E(t) - E(0) is the work of the reactions: the residual of the energy balance decreases with the step size.
TEST(EnergyOfMemory, BalanceCloses) {
  const auto residual = [](const Scene& scene, int steps) {
    EnergyObserver balance(scene.energy);
    const auto path = solve("product_trapezoidal", scene.problem, steps);
    for (int n = 0; n <= steps; ++n)
      balance.observe(path.time(n), columns_at(scene.outputs, path.time(n), path.y.col(n)));
    return *balance.residual();
  };
  for (const Form& form :
       {Form{"fractional_constraint_2d", {}}, Form{"fractional_constraint_2d", {{"alpha", 0.8}}},
        Form{"fractional_constraint_2d", {{"alpha", 1.5}, {"b2", 0.3}, {"C0", 0.2}}},
        Form{"fractional_knife_edge", {}}}) {
    const Scene scene = scene_of(form.scene, form.values);
    const double fine = residual(scene, 2048);
    EXPECT_LT(fine, 1e-3) << scene.name;
    EXPECT_LT(fine, 0.45 * residual(scene, 1024)) << scene.name;
  }
}

// Exact for polynomials of degree 4, and at the start for sums of the powers.
TEST(DifferentiationRule, IsThatOfWhatItIsMadeFor) {
  for (const double grading : {1.0, 2.5}) {
    const Grid grid{3.0, 100, grading};
    const auto differentiated = [&](int n, const std::vector<double>& powers, const auto& f) {
      const auto [steps, weights] = differentiation_rule(grid, n, powers);
      double sum = 0.0;
      for (std::size_t k = 0; k < steps.size(); ++k)
        sum += weights[static_cast<Eigen::Index>(k)] * f(grid.time(steps[k]));
      return sum;
    };
    for (const int n : {1, 2, 50, 99, 100}) {
      const double t = grid.time(n);
      const auto quartic = [](double x) { return 1.0 - x + std::pow(x, 4); };
      EXPECT_NEAR(differentiated(n, {}, quartic), -1.0 + 4.0 * t * t * t, 1e-9) << n;
      const auto start = [](double x) { return 2.0 + std::pow(x, 0.4) - std::pow(x, 0.8) + 3.0 * x; };
      const double slope = 0.4 * std::pow(t, -0.6) - 0.8 * std::pow(t, -0.2) + 3.0;
      const double allowed = n < 16 ? 1e-9 : 1e-5;
      EXPECT_NEAR(differentiated(n, {0.4, 0.8, 1.0, 1.2}, start), slope, allowed * (1.0 + std::abs(slope)))
          << n;
    }
  }
  EXPECT_EQ(differentiation_rule({1.0, 2}, 2, {0.5}).steps, (std::vector{0, 1, 2}));
}

// A start like t^0.4 plus an oscillation, with perturbed values; up to the end.
TEST(DifferentiationRule, OfValuesAtAnyTime) {
  for (const double noise : {0.0, 1e-9}) {
    const auto value = [&](double x) {
      return Vec::Constant(1, std::pow(x, 0.4) + std::sin(40.0 * x) + noise * std::sin(1e7 * x)).eval();
    };
    for (const double t : {1e-9, 1e-3, 0.7, 4.999, 5.0}) {
      const double slope = 0.4 * std::pow(t, -0.6) + 40.0 * std::cos(40.0 * t);
      EXPECT_NEAR(derivative_at(t, 5.0, value)[0], slope, (noise == 0.0 ? 1e-7 : 1e-4) * (40.0 + slope)) << t;
      const auto times = derivative_times(t, 5.0);
      EXPECT_TRUE(std::ranges::is_sorted(times));
      EXPECT_TRUE(times.front() > 0.0 && times.back() <= 5.0);
      (void)derivative_at(t, 5.0, [&](double at) {
        EXPECT_TRUE(at == t || std::ranges::binary_search(times, at)) << at;
        return value(at);
      });
    }
  }
}

}  // namespace
}  // namespace fde::bench
