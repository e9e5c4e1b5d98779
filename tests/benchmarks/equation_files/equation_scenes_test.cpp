// SPDX-License-Identifier: MIT
// Equation files of scenes that are also compiled in: the same columns with every scheme.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "fdebench/schemes/problem/jacobian.hpp"
#include "fdebench/schemes/stepping/rates.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

struct BuiltInCounterpart {
  std::string id;
  double until;  // short enough that rounding errors do not grow further
};

class TwinScenes : public testing::TestWithParam<std::tuple<const Scheme*, BuiltInCounterpart>> {};

// Columns with the same name are compared; in files, derivatives are named by their orders.
TEST_P(TwinScenes, HaveTheSameColumns) {
  const auto& [scheme, twin] = GetParam();
  Scene file = scene_of_example(twin.id + ".toml"), code = scene_of(twin.id);
  file.problem.end = code.problem.end = twin.until;
  const Grid grid{twin.until, 256};
  ASSERT_EQ(unsupported_reason(*scheme, file.problem, grid).has_value(),
            unsupported_reason(*scheme, code.problem, grid).has_value());
  if (unsupported_reason(*scheme, code.problem, grid)) return;
  const auto from_file = scheme->solve(file.problem, grid, {}),
             of_code = scheme->solve(code.problem, grid, {});
  ASSERT_EQ(from_file.status, of_code.status);
  const auto a = columns_of(file.outputs, from_file), b = columns_of(code.outputs, of_code);
  const double allowed = rounding_allowance(*scheme, 1e-12);
  int compared = 0;
  for (std::size_t i = 0; i < file.outputs.names.size(); ++i) {
    const auto found = std::ranges::find(code.outputs.names, file.outputs.names[i]);
    if (found == code.outputs.names.end()) continue;
    ++compared;
    const auto ours = a.row(static_cast<Eigen::Index>(i)), theirs = b.row(found - code.outputs.names.begin());
    EXPECT_LT((ours - theirs).cwiseAbs().maxCoeff(), allowed * (1.0 + theirs.cwiseAbs().maxCoeff()));
  }
  EXPECT_GT(compared, 0);
}

INSTANTIATE_TEST_SUITE_P(OfEveryScheme, TwinScenes,
                         testing::Combine(testing::ValuesIn(grid_schemes()),
                                          testing::Values(BuiltInCounterpart{"brusselator", 5.0},
                                                          BuiltInCounterpart{"pendulum", 20.0},
                                                          BuiltInCounterpart{"bagley_torvik", 16.0})),
                         [](const auto& test) {
                           return std::string(std::get<0>(test.param)->id) + "_" + std::get<1>(test.param).id;
                         });

TEST(EquationFile, ExpectsTheRatesOfItsTwin) {
  for (const std::string id : {"brusselator", "pendulum", "bagley_torvik"}) {
    const Scene file = scene_of_example(id + ".toml"), code = scene_of(id);
    for (const auto* scheme : grid_schemes()) {
      for (const double grading : {1.0, 2.0}) {
        if (unsupported_reason(*scheme, code.problem, Grid{1.0, 64, grading})) continue;
        for (const Norm norm : {Norm::end, Norm::maximum}) {
          EXPECT_EQ(theoretical_rate(*scheme, file.problem, file.smoothness, grading, norm),
                    theoretical_rate(*scheme, code.problem, code.smoothness, grading, norm))
              << id << " " << scheme->id << " " << grading;
        }
      }
    }
  }
}

TEST(EquationFile, HasTheEnergyOfThePendulum) {
  const Scene file = scene_of_example("pendulum.toml"), code = scene_of("pendulum");
  ASSERT_EQ(file.outputs.names, (std::vector<std::string>{"phi", "D(phi,0.5)", "D(phi,1)", "D(phi,1.5)"}));
  const Vec columns = (Vec(4) << 0.3, -0.7, 1.1, 0.4).finished();  // phi, Dbeta_phi, dphi, Dalpha_phi
  EXPECT_NEAR(file.energy.value(columns), code.energy.value(columns), 1e-15);
  EXPECT_NEAR(file.energy.power(0.0, columns), code.energy.power(0.0, columns), 1e-15);
}

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
                         testing::Values("brusselator.toml", "pendulum.toml", "bagley_torvik.toml",
                                         "duffing.toml", "multi_order.toml"));

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
