// SPDX-License-Identifier: MIT
// Right-hand sides as functions of y - y(0).

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "fdebench/benchmarks/expressions/formula.hpp"
#include "fdebench/benchmarks/expressions/program.hpp"
#include "fdebench/benchmarks/expressions/values_at_start.hpp"
#include "fdebench/benchmarks/measures/rounding.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// The formula in z = (x - 0.3, y + 1.2) at t = 0.7; nullopt: no constants cancel.
std::optional<double> in_increments_at(const std::string& text, double x, double y) {
  ExpressionPool pool(NumberStorage::values);
  const auto formula = read_formula(text, names_of_t_x_y(pool), pool);
  const auto shifted = in_increments({formula}, (Vec(2) << 0.3, -1.2).finished(), pool);
  if (!shifted) return std::nullopt;
  return Program(pool, *shifted, 2)(0.7, (Vec(2) << x, y).finished());
}

TEST(Increments, OfDifferencesFromTheOriginHaveNoRounding) {
  const double z = 1e-30;
  EXPECT_EQ(in_increments_at("x - 0.3", z, 0.0), z);
  EXPECT_EQ(in_increments_at("0.3 - x", z, 0.0), -z);
  EXPECT_EQ(in_increments_at("x + y + 0.9", z, z), 2.0 * z);
  EXPECT_EQ(in_increments_at("4*x + y", z, z), 4.0 * z + z);
  EXPECT_EQ(in_increments_at("-(x/0.25) - y", z, 0.0), -4.0 * z);
  EXPECT_EQ(in_increments_at("(1.2 + y)^2", 0.0, z), z * z);
  EXPECT_EQ(in_increments_at("sqrt((x - 0.1 - 0.2)*(y + 1.2))", z, z), z);
}

TEST(Increments, AgreeWithTheFormula) {
  ExpressionPool pool(NumberStorage::values);
  const double x = 0.25, y = 0.5;
  for (const std::string text :
       {"x - 0.3 + t", "(x - 0.3)*(2 - 3*y)/(1 + x) + t - 1", "exp(y + 1.2)*x - (x - 0.3)^2.5 - sin(x/2)",
        "2*(x - 0.3) + 3*(4 - y) - t*x"}) {
    const auto formula = read_formula(text, names_of_t_x_y(pool), pool);
    const double value = Program(pool, {formula}, 2)(0.7, (Vec(2) << x + 0.3, y - 1.2).finished());
    const auto shifted = in_increments_at(text, x, y);
    ASSERT_TRUE(shifted) << text;
    EXPECT_NEAR(*shifted, value, 1e-15 * (1.0 + std::abs(value))) << text;
  }
}

TEST(Increments, AreNotNeededWhereNothingCancels) {
  EXPECT_FALSE(in_increments_at("x + y", 0.1, 0.2));
  EXPECT_FALSE(in_increments_at("sin(x) - 0.3*t", 0.1, 0.2));
  EXPECT_FALSE(in_increments_at("x - 0.30000000000000004", 0.1, 0.2));
}

// The exact f has relative accuracy at every time, though y3 - 0.3 = t^1.8 is lost in y3 from t = 1e-9 down.
TEST(Increments, OfTheMultiOrderProblemKeepItsStart) {
  const Scene scene = scene_of_example("multi_order.toml");
  const auto& form = scene.problem.increments;
  ASSERT_TRUE(form.is_given());
  EXPECT_EQ(form.origin, (Vec(3) << 1.0, 0.5, 0.3).finished());
  for (const double t : {0.3, 1e-10, 1e-100}) {
    const Vec z = (Vec(3) << t, std::pow(t, 1.2), std::pow(t, 1.8)).finished();
    Vec f(3);
    form.rhs(t, z, f);
    EXPECT_NEAR(f[0] / (std::sqrt(t) / std::tgamma(1.5)), 1.0, 1e-13) << t;
    EXPECT_NEAR(f[1] / (std::tgamma(2.2) * t), 1.0, 1e-15) << t;
    EXPECT_NEAR(f[2] / (std::tgamma(2.8) / std::tgamma(2.2) * z[1]), 1.0, 1e-15) << t;
    // d/dz2 ((z2 z3)^(1/6) / sqrt pi) = t^0.5 / (6 z2 sqrt pi)
    Matrix jacobian = Matrix::Zero(3, 3);
    form.jacobian(t, z, jacobian);
    EXPECT_NEAR(jacobian(0, 1) * 6.0 * z[1] * std::sqrt(std::numbers::pi / t), 1.0, 1e-12) << t;
  }
}

TEST(Increments, AreGivenWhereADerivativeIsInfiniteAtTheStart) {
  for (const auto* id : {"relaxation", "pendulum", "brusselator", "extensible_pendulum"})
    EXPECT_FALSE(scene_of(id).problem.increments.is_given()) << id;
}

TEST(Increments, FollowTheUnitOfTheUnknowns) {
  const Scene scene = scene_of_example("multi_order.toml");
  const Problem other = rescaled_problem(8.0, scene.problem);
  ASSERT_TRUE(other.increments.is_given());
  const double t = 1e-20;
  const Vec z = (Vec(3) << t, std::pow(t, 1.2), std::pow(t, 1.8)).finished();
  Vec f(3), in_units(3);
  scene.problem.increments.rhs(t, z, f);
  other.increments.rhs(t, z / 8.0, in_units);
  EXPECT_EQ(in_units * 8.0, f);
  Matrix jacobian = Matrix::Zero(3, 3), same = jacobian;
  scene.problem.increments.jacobian(t, z, jacobian);
  other.increments.jacobian(t, z / 8.0, same);
  EXPECT_EQ(jacobian, same);
}

}  // namespace
}  // namespace fde::bench
