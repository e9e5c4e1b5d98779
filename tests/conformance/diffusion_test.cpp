// Diffusion and waves on lines and squares: their closed form is that of the semi-discrete problem, and the
// error of a scheme is one of time alone, whatever the number of unknowns.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "mittag_leffler/mittag_leffler.hpp"
#include "support/testing.hpp"

namespace fde {
namespace {

struct Field {
  std::string name, scene;
  ParameterValues values;
};

std::vector<Field> fields() {
  std::vector<Field> all;
  for (const double order : {0.1, 0.5, 1.0, 1.6}) {
    for (const auto* start : {"smooth", "step"}) {
      const auto name = std::string(start) + "_" + std::to_string(std::lround(10 * order));
      const ParameterValues shared{{"gamma", order}, {"start", start}, {"diffusivity", 0.02}};
      ParameterValues line = shared, square = shared;
      line["components"] = 24.0;
      square["n"] = 5.0;
      all.push_back({"line_" + name, "fractional_diffusion", line});
      all.push_back({"square_" + name, "fractional_diffusion_2d", square});
    }
  }
  return all;
}

class DiffusionOf : public testing::TestWithParam<Field> {};
INSTANTIATE_TEST_SUITE_P(, DiffusionOf, testing::ValuesIn(fields()),
                         [](const auto& test) { return test.param.name; });

// E_g(A t^g) u(0) by the eigenvectors that a library finds of the matrix.
TEST_P(DiffusionOf, IsTheMittagLefflerFunctionOfItsMatrix) {
  const Scene scene = scene_of(GetParam().scene, GetParam().values);
  const double order = scene.problem.components.front().order;
  const Eigen::SelfAdjointEigenSolver<Matrix> modes(
      Matrix(std::get<SparseLinearPart>(scene.problem.derivatives).matrix));
  for (const double t : {0.0, 0.01, 1.0, 30.0}) {
    const Vec parts = modes.eigenvalues().unaryExpr(
        [&](double rate) { return mittag_leffler(order, 1.0, rate * std::pow(t, order)); });
    const Vec u = modes.eigenvectors() *
                  parts.cwiseProduct(modes.eigenvectors().transpose() * taylor_part(scene.problem, 0.0));
    const ReferenceValue known = scene.reference.at(t);
    EXPECT_LT((known.value - columns_at(scene.outputs, t, u)).cwiseAbs().maxCoeff(), 2e-13) << t;
    EXPECT_LT(known.bound.maxCoeff(), 1e-12) << t;
  }
}

TEST(Diffusion, ShowsAFewPointsAndTheNormOfMoreThanTwoThousand) {
  using Names = std::vector<std::string>;
  const auto all = scene_of("fractional_diffusion", {{"components", 2000.0}}).outputs.names;
  EXPECT_EQ(all.size(), 2000U);
  EXPECT_EQ(all.back(), "u2000");
  EXPECT_EQ(scene_of("fractional_diffusion", {{"components", 999999.0}}).outputs.names,
            (Names{"u100000", "u200000", "u300000", "u400000", "u500000", "u600000", "u700000", "u800000",
                   "u900000", "l2"}));
  EXPECT_EQ(scene_of("fractional_diffusion_2d", {{"n", 999.0}}).outputs.names,
            (Names{"u250_250", "u250_500", "u250_750", "u500_250", "u500_500", "u500_750", "u750_250",
                   "u750_500", "u750_750", "l2"}));
}

// At x = 1/10, 1/2, 9/10 and in the norm, where lines of any number of points may be compared.
Vec errors(double points, const char* scheme, const Grid& grid) {
  const Scene scene = scene_of("fractional_diffusion", {{"components", points}});
  const auto path = find_scheme(scheme)->solve(scene.problem, grid, {.at = {grid.end}});
  EXPECT_EQ(path.ending, Ending::finished);
  EXPECT_EQ(path.cost.linear_solver, "tridiagonal");
  const Vec error = columns_at(scene.outputs, grid.end, path.y.col(0)) - scene.reference.at(grid.end).value;
  return error({0, 4, 8, 9});
}

TEST(Diffusion, HasTheSameErrorsWithAHundredTimesAsManyPoints) {
  for (const auto* scheme : {"l1", "product_trapezoidal"}) {
    const Vec few = errors(2999.0, scheme, {1.0, 64}), many = errors(299999.0, scheme, {1.0, 64});
    EXPECT_LT(((many - few).array() / few.array()).abs().maxCoeff(), 1e-3) << scheme;
  }
}

}  // namespace
}  // namespace fde
