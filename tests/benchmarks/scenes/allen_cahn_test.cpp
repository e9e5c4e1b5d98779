// SPDX-License-Identifier: MIT
// The fractional Allen-Cahn equation on insulated lines and squares: its symmetries, its stationary states,
// and its solutions that do not vary in space.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

Scene allen_cahn(const ParameterValues& values, double end = 2.0) {
  Scene scene = scene_of("fractional_allen_cahn", values);
  scene.problem.end = end;
  return scene;
}

Vec last(const char* scheme, const Problem& problem, const Grid& grid) {
  const auto path = solve(scheme, problem, grid, {.output_times = {grid.end}});
  EXPECT_EQ(path.status, SolveStatus::finished);
  return path.y.col(0);
}

struct Run {
  std::string domain;
  double gamma, grading;
};

class AllenCahn : public testing::TestWithParam<Run> {
 protected:
  [[nodiscard]] static Scene scene(const char* start, double amplitude = 0.5) {
    return allen_cahn({{"domain", GetParam().domain},
                       {"gamma", GetParam().gamma},
                       {"n", 6.0},
                       {"start", start},
                       {"amplitude", amplitude}});
  }
  [[nodiscard]] static Vec solved(const Problem& problem) {
    return last("l1", problem, {problem.end, 64, GetParam().grading});
  }
};
INSTANTIATE_TEST_SUITE_P(, AllenCahn,
                         testing::Values(Run{"line", 0.4, 1.0}, Run{"line", 0.8, 2.0}, Run{"line", 1.5, 1.0},
                                         Run{"square", 0.4, 2.0}, Run{"square", 1.0, 1.0},
                                         Run{"square", 1.5, 2.0}),
                         [](const auto& test) {
                           return test.param.domain + "_" +
                                  std::to_string(std::lround(10 * test.param.gamma)) +
                                  (test.param.grading > 1.0 ? "_graded" : "");
                         });

// D^g u = u - u^3.
TEST_P(AllenCahn, OfAnEvenStartIsAScalarEquation) {
  const Scene field = scene("even", 0.3);
  const Problem scalar{.components = {field.problem.components.front()},
                       .rhs = [](double, In u, Out f) { f[0] = u[0] - u[0] * u[0] * u[0]; },
                       .end = field.problem.end};
  const double alone = solved(scalar)[0];
  EXPECT_LT((solved(field.problem).array() - alone).abs().maxCoeff(), 1e-13);
}

TEST_P(AllenCahn, RestsAtOneAndAtMinusOneAndAtZero) {
  for (const double rest : {1.0, -1.0, 0.0})
    EXPECT_LT((solved(scene("even", rest).problem).array() - rest).abs().maxCoeff(), 1e-15);
}

TEST_P(AllenCahn, ChangesSignWithItsStart) {
  const Vec up = solved(scene("smooth", 0.5).problem), down = solved(scene("smooth", -0.5).problem);
  EXPECT_LT((up + down).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_GT(up.cwiseAbs().maxCoeff(), 0.1);
}

// A step is odd about the middle of x, and so is its solution; a square is its own mirror image.
TEST_P(AllenCahn, KeepsTheSymmetriesOfItsStart) {
  const Vec u = solved(scene("step").problem), mixed = solved(scene("smooth").problem);
  const Eigen::Index n = 6, lines = u.size() / n;
  const auto rows = u.reshaped(n, lines), mixed_rows = mixed.reshaped(n, lines);
  EXPECT_LT((rows + rows.colwise().reverse()).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_GT((mixed_rows - mixed_rows.colwise().reverse()).cwiseAbs().maxCoeff(), 0.1);
  if (lines > 1) {
    EXPECT_LT((mixed_rows - mixed_rows.transpose()).cwiseAbs().maxCoeff(), 1e-13);
  }
}

// Up to order 1: max |u| stays below 1, and the free energy below that of the start (Tang, Yu & Zhou 2019).
TEST_P(AllenCahn, StaysWithinItsWellsAndLosesEnergy) {
  if (GetParam().gamma > 1.0) return;
  const Scene field = scene("step", 1.0);
  const auto energy = [&](const Vec& u) {
    Vec f(u.size());
    field.problem.rhs(0.0, u, f);  // epsilon^2 Laplace(u) + u - u^3
    const Vec differences = f.array() - u.array() + u.array().cube();
    return -0.5 * u.dot(differences) + 0.25 * (1.0 - u.array().square()).square().sum();
  };
  const auto path = solve("l1", field.problem, Grid{2.0, 64, GetParam().grading});
  const double at_start = energy(path.y.col(0));
  for (Eigen::Index n = 1; n < path.y.cols(); ++n) {
    EXPECT_LE(path.y.col(n).cwiseAbs().maxCoeff(), 1.0 + 1e-12);
    EXPECT_LT(energy(path.y.col(n)), at_start);
  }
}

// A square that does not vary with y.
TEST(AllenCahnFields, InASquareIncludesThatOnALine) {
  const Scene line = allen_cahn({{"n", 6.0}});
  Scene square = allen_cahn({{"n", 6.0}, {"domain", "square"}});
  for (std::size_t place = 0; place < 36; ++place)
    square.problem.components[place] = line.problem.components[place % 6];
  const Vec on_line = last("l1", line.problem, {2.0, 64}), in_square = last("l1", square.problem, {2.0, 64});
  EXPECT_LT((in_square.reshaped(6, 6).colwise() - on_line).cwiseAbs().maxCoeff(), 1e-13);
}

// y' = y - y^3: y(t) = y0 e^t / sqrt(1 + y0^2 (e^(2 t) - 1)).
TEST(AllenCahnFields, OfOrderOneAndEvenIsTheClassicalMotionBetweenWells) {
  const Scene field = allen_cahn({{"gamma", 1.0}, {"start", "even"}, {"amplitude", 0.1}, {"n", 4.0}});
  const double exact = 0.1 * std::exp(2.0) / std::sqrt(1.0 + 0.01 * (std::exp(4.0) - 1.0));
  EXPECT_LT((reference_of(field).at(2.0).value.array() - exact).abs().maxCoeff(), 1e-13);
}

// The sparse Jacobian is that of the right-hand side: the same scheme with differences gives the same result.
TEST(AllenCahnFields, NewtonsMatricesAreSparse) {
  for (const auto& [domain, solver] : {std::pair{"line", "tridiagonal"}, {"square", "cholesky"}}) {
    Scene field = allen_cahn({{"domain", domain}, {"n", 5.0}});
    const auto run = [&] { return solve("product_trapezoidal", field.problem, Grid{2.0, 64}); };
    const auto first = run();
    EXPECT_EQ(first.cost.linear_solver, solver);
    field.problem.derivatives = NoDerivatives{};
    EXPECT_LT((run().y - first.y).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(AllenCahnFields, OfMoreThanFourHundredUnknownsHaveNoReferenceAndSaySo) {
  EXPECT_EQ(message_of<std::runtime_error>([] {
              reference_of(allen_cahn({{"n", 401.0}}));
            }),
            "the two methods of a reference take up to 400 unknowns, not 401");
}

TEST(AllenCahnFields, InASquareHaveAtMostAThousandCellsAnAxis) {
  EXPECT_EQ(allen_cahn({{"n", 1001.0}}).problem.size(), 1001);
  EXPECT_EQ(message_of<std::invalid_argument>([] {
              allen_cahn({{"n", 1001.0}, {"domain", "square"}});
            }),
            "n = 1001: must be at most 1000 in a square");
}

}  // namespace
}  // namespace fde::bench
