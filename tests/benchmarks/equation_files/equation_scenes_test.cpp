// SPDX-License-Identifier: MIT
// Problems made from equation files: Jacobians, linearity, chains, columns.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "fdebench/schemes/problem/problem.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

class ExampleJacobian : public testing::TestWithParam<std::string> {};

TEST_P(ExampleJacobian, IsThatOfTheDifferences) {
  const Scene scene = scene_of_example(GetParam());
  ASSERT_TRUE(has_jacobian(scene.problem));
  Problem untold = scene.problem;
  untold.derivatives = NoDerivatives{};
  const Vec y = Vec::LinSpaced(scene.problem.size(), 0.9, 1.7);
  const Matrix exact = jacobian_at(scene.problem, 0.4, y), differences = jacobian_at(untold, 0.4, y);
  EXPECT_LT((exact - differences).cwiseAbs().maxCoeff(), 1e-9 * (1.0 + exact.cwiseAbs().maxCoeff()));
}

INSTANTIATE_TEST_SUITE_P(Examples, ExampleJacobian,
                         testing::Values("duffing.toml", "falling.toml", "multi_order.toml"));

struct Linearity {
  std::string rhs;
  bool linear;
};

class LinearRightHandSide : public testing::TestWithParam<Linearity> {};

TEST_P(LinearRightHandSide, IsRecognised) {
  const auto& [rhs, expected] = GetParam();
  EXPECT_EQ(is_linear(scene_of_text(relaxation_file(rhs)).problem), expected) << rhs;
}

INSTANTIATE_TEST_SUITE_P(Kinds, LinearRightHandSide,
                         testing::Values(Linearity{"-x", true}, Linearity{"-2*x/3 + cos(t) - x", true},
                                         Linearity{"(x + 1)^2 - x^2", true},
                                         Linearity{"x*(1 - x) + x^2", true}, Linearity{"exp(t)", true},
                                         Linearity{"-t*x", false}, Linearity{"-x^2", false},
                                         Linearity{"-abs(x)", false}, Linearity{"sin(x)", false}));

TEST(EquationFile, TakesTermsOnTheLeftAndDerivativesOnTheRight) {
  const std::string left = "end = 2\n[unknown.x]\nterms = [[2, 1.5], [0.3, 0.5], [4, 0]]\nrhs = \"t\"\n";
  const std::string right =
      "end = 2\n[unknown.x]\nterms = [[2, 1.5], [0.1, 0.5]]\nrhs = \"t - 0.2*D(x, 1/2) - 4*D(x, 0)\"\n";
  const auto initial = std::string("initial = [1, 0.5]\n");
  const Scene a = scene_of_text(left + initial), b = scene_of_text(right + initial);
  const Vec y = (Vec(3) << 0.3, -0.7, 1.1).finished();
  Vec f(3), g(3);
  a.problem.rhs(0.4, y, f);
  b.problem.rhs(0.4, y, g);
  // D^1.5 x = (t - 0.3 D^0.5 x - 4 x) / 2
  EXPECT_NEAR(f[2], (0.4 + 0.3 * 0.7 - 4.0 * 0.3) / 2.0, 1e-15);
  EXPECT_LT((f - g).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_EQ(a.outputs.names, (std::vector<std::string>{"x", "D(x,0.5)", "D(x,1)"}));
}

TEST(EquationFile, KeepsTheOrderOfItsUnknowns) {
  const Scene scene = scene_of_text(
      "end = 1\n[unknown.z]\norder = 0.5\nrhs = \"a\"\ninitial = [1]\n"
      "[unknown.a]\norder = 0.7\nrhs = \"-z\"\ninitial = [2]\n");
  EXPECT_EQ(scene.outputs.names, (std::vector<std::string>{"z", "a"}));
  EXPECT_EQ(scene.problem.components[1].order, 0.7);
}

TEST(EquationFile, TakesAlgebraicRows) {
  const Scene scene = scene_of_text(
      "end = 1\n[unknown.x]\norder = 0.5\nrhs = \"-z\"\ninitial = [1]\n"
      "[unknown.z]\norder = 0\nrhs = \"z - 2*x\"\ninitial = [2]\n");
  EXPECT_TRUE(is_algebraic(scene.problem.components[1]));
  // z = 2 x, D^0.5 x = -2 x: x = E_0.5(-2 sqrt(t)) = e^(4t) erfc(2 sqrt(t)).
  const auto known = scene.reference.at(0.25);
  EXPECT_NEAR(known.value[0], std::exp(1.0) * std::erfc(1.0), 1e-15);
  EXPECT_NEAR(known.value[1], 2.0 * std::exp(1.0) * std::erfc(1.0), 1e-15);
  const auto path = solve("product_trapezoidal", scene.problem, 1024, {.output_times = {1.0}});
  EXPECT_NEAR(path.y(1, 0), scene.reference.at(1.0).value[1], 1e-4);
}

}  // namespace
}  // namespace fde::bench
