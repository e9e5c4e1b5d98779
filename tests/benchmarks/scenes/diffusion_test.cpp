// SPDX-License-Identifier: MIT
// Diffusion and waves on lines and squares, in even and other media. The reference is the solution of the
// semi-discrete problem, so the error of a scheme is the error in time alone, whatever the number of
// unknowns.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <ostream>
#include <tuple>
#include <utility>

#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "fdebench/schemes/stepping/rates.hpp"
#include "support/testing.hpp"

namespace fde::bench {
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
      if (order < 0.3) continue;
      for (const auto* medium : {"wave", "halves"}) {
        line["medium"] = square["medium"] = medium;
        all.push_back({"line_" + name + "_" + medium, "fractional_diffusion", line});
        all.push_back({"square_" + name + "_" + medium, "fractional_diffusion_2d", square});
      }
    }
  }
  return all;
}

class DiffusionOf : public testing::TestWithParam<Field> {};
INSTANTIATE_TEST_SUITE_P(, DiffusionOf, testing::ValuesIn(fields()), name_of_param);

// E_g(A t^g) u(0) by the eigenvectors of the matrix, computed by Eigen.
TEST_P(DiffusionOf, IsTheMittagLefflerFunctionOfItsMatrix) {
  const Scene scene = scene_of(GetParam().scene, GetParam().values);
  const double order = scene.problem.components.front().order;
  const Eigen::SelfAdjointEigenSolver<Matrix> modes(
      Matrix(std::get<SparseLinearPart>(scene.problem.derivatives).matrix));
  for (const double t : {0.0, 0.01, 1.0, 30.0}) {
    const Vec parts = modes.eigenvalues().unaryExpr(
        [&](double rate) { return reference::mittag_leffler(order, 1.0, rate * std::pow(t, order)); });
    const Vec u = modes.eigenvectors() *
                  parts.cwiseProduct(modes.eigenvectors().transpose() * taylor_part(scene.problem, 0.0));
    const reference::ReferenceValue known = scene.reference.at(t);
    EXPECT_LT((known.value - columns_at(scene.outputs, t, u)).cwiseAbs().maxCoeff(), 2e-13) << t;
    EXPECT_LT(known.bound.maxCoeff(), 1e-12) << t;
  }
}

Matrix matrix_of(const Scene& scene) {
  return Matrix(std::get<SparseLinearPart>(scene.problem.derivatives).matrix);
}

// In an even medium the solutions by computed eigenvectors and by sines are equal.
TEST(Diffusion, ThroughAMediumWithoutContrastIsThatThroughAnEvenOne) {
  for (const auto& [scene, points] :
       {std::pair{"fractional_diffusion", "components"}, {"fractional_diffusion_2d", "n"}}) {
    for (const double order : {0.3, 1.0, 1.7}) {
      ParameterValues values{{points, 40.0}, {"gamma", order}, {"start", "step"}};
      const Scene even = scene_of(scene, values);
      values.insert({{"medium", "wave"}, {"contrast", 1.0}});
      const Scene varying = scene_of(scene, values);
      EXPECT_EQ(matrix_of(even), matrix_of(varying));
      for (const double t : {0.0, 1e-4, 0.1, 20.0}) {
        const reference::ReferenceValue one = even.reference.at(t), other = varying.reference.at(t);
        EXPECT_EQ(even.outputs.names, varying.outputs.names);
        EXPECT_LT(((one.value - other.value).cwiseAbs() - one.bound - other.bound).maxCoeff(), 0.0) << t;
        EXPECT_LT(other.bound.maxCoeff(), order > 1.0 ? 1e-10 : 1e-12) << order << " " << t;
      }
    }
  }
}

// (a u')' of u = sin(pi x) with a = c^(sin^2 pi x): a (u'' + log(c) pi sin(2 pi x) u').
TEST(Diffusion, DifferencesOfAVaryingMediumAreOfSecondOrder) {
  constexpr double pi = std::numbers::pi, contrast = 5.0;
  const auto error = [&](double points) {
    const Scene scene = scene_of("fractional_diffusion",
                                 {{"components", points}, {"medium", "wave"}, {"contrast", contrast}});
    const Vec x = Vec::LinSpaced(static_cast<Eigen::Index>(points), 1.0, points) / (points + 1.0);
    const Vec u = (pi * x.array()).sin();
    Vec f(u.size());
    scene.problem.rhs(0.0, u, f);
    EXPECT_LT((matrix_of(scene) * u - f).cwiseAbs().maxCoeff(), 1e-9);
    const auto exact = [&](double at) {
      const double a = std::pow(contrast, std::sin(pi * at) * std::sin(pi * at));
      return a * pi * pi *
             (std::log(contrast) * std::sin(2.0 * pi * at) * std::cos(pi * at) - std::sin(pi * at));
    };
    return (f - x.unaryExpr(exact)).cwiseAbs().maxCoeff();
  };
  EXPECT_NEAR(std::log2(error(99.0) / error(199.0)), 2.0, 0.02);
}

// The flux that leaves a point enters its neighbours.
TEST(Diffusion, ConservesWhatDiffuses) {
  for (const auto* medium : {"wave", "halves"}) {
    const Matrix line =
        matrix_of(scene_of("fractional_diffusion", {{"components", 9.0}, {"medium", medium}}));
    const Matrix square = matrix_of(scene_of("fractional_diffusion_2d", {{"n", 5.0}, {"medium", medium}}));
    EXPECT_EQ(line, line.transpose());
    EXPECT_EQ(square, square.transpose());
    EXPECT_LT(line.colwise().sum().segment(1, 7).cwiseAbs().maxCoeff(), 1e-12 * line.norm());
    EXPECT_LT(std::abs(square.col(12).sum()), 1e-12 * square.norm());
  }
}

// The error bound of the eigenvector expansion for orders above 1 depends on this.
TEST(Diffusion, SlopesOfWavesAreLargestAtTheStart) {
  for (double order = 1.05; order <= 2.0; order += 0.05) {
    for (double z = 0.0; z < 400.0; z = 1.1 * z + 0.05) {
      EXPECT_LE(std::abs(reference::mittag_leffler(order, order, -z)), (1.0 + 1e-14) / std::tgamma(order))
          << order << " " << z;
    }
  }
}

TEST(Diffusion, ThroughAVaryingMediumIsKnownWhereEigenvectorsTakeSeconds) {
  const auto known = [](const char* scene, ParameterValues values) {
    values["medium"] = "wave";
    return static_cast<bool>(scene_of(scene, values).reference.at);
  };
  EXPECT_TRUE(known("fractional_diffusion", {{"components", 500.0}}));
  EXPECT_FALSE(known("fractional_diffusion", {{"components", 501.0}}));
  EXPECT_TRUE(known("fractional_diffusion_2d", {{"n", 346.0}}));
  EXPECT_FALSE(known("fractional_diffusion_2d", {{"n", 347.0}}));
  EXPECT_TRUE(known("fractional_diffusion_2d", {{"n", 100.0}, {"start", "step"}}));
}

TEST(Diffusion, ShowsAFewPointsAndNormsOfMoreThanTwoThousand) {
  using Names = std::vector<std::string>;
  const auto all = scene_of("fractional_diffusion", {{"components", 2000.0}}).outputs.names;
  EXPECT_EQ(all.size(), 2000U);
  EXPECT_EQ(all.back(), "u2000");
  Names line{"u100000", "u200000", "u300000", "u400000", "u500000", "u600000",
             "u700000", "u800000", "u900000", "l2",      "max"};
  EXPECT_EQ(scene_of("fractional_diffusion", {{"components", 999999.0}}).outputs.names, line);
  line.pop_back();  // a million modes at a million points
  EXPECT_EQ(scene_of("fractional_diffusion", {{"components", 999999.0}, {"start", "step"}}).outputs.names,
            line);
  EXPECT_EQ(scene_of("fractional_diffusion_2d", {{"n", 999.0}}).outputs.names,
            (Names{"u250_250", "u250_500", "u250_750", "u500_250", "u500_500", "u500_750", "u750_250",
                   "u750_500", "u750_750", "l2", "max"}));
}

// Errors of all output columns, norms included. Points and modes are such that fields of any size are
// comparable.
Vec errors(const char* scene_id, const ParameterValues& values, const char* scheme, const Grid& grid) {
  const Scene scene = scene_of(scene_id, values);
  const auto path = solve(scheme, scene.problem, grid, {.output_times = {grid.end}});
  EXPECT_EQ(path.status, SolveStatus::finished);
  return columns_at(scene.outputs, grid.end, path.y.col(0)) - scene.reference.at(grid.end).value;
}

// With 64 intervals the decay rate of the third mode is 0.2 % below its limit for many intervals.
void expect_same(const Vec& few, const Vec& many, const char* what) {
  const double size = few.cwiseAbs().maxCoeff();
  ASSERT_GT(size, 1e-8) << what;
  EXPECT_LT((many - few).cwiseAbs().maxCoeff(), 4e-3 * size) << what;
}

Vec errors_on_a_line(double points, const char* scheme, double grading) {
  return errors("fractional_diffusion", {{"components", points}}, scheme, {1.0, 64, grading});
}
Vec errors_in_a_square(double side, const char* scheme) {
  return errors("fractional_diffusion_2d", {{"n", side}}, scheme, {1.0, 64});
}

TEST(Diffusion, HasTheSameErrorsWithManyTimesAsManyUnknowns) {
  for (const auto* scheme : {"l1", "product_trapezoidal"}) {
    expect_same(errors_on_a_line(2999.0, scheme, 1.0), errors_on_a_line(99999.0, scheme, 1.0), scheme);
    expect_same(errors_on_a_line(2999.0, scheme, 3.0), errors_on_a_line(29999.0, scheme, 3.0), scheme);
    expect_same(errors_in_a_square(63.0, scheme), errors_in_a_square(191.0, scheme), scheme);
  }
}

struct Rough {
  std::string scheme, medium;
  bool graded;
};

// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest looks for this name.
void PrintTo(const Rough& rough, std::ostream* out) {
  *out << rough.scheme << " " << rough.medium << (rough.graded ? " graded" : "");
}

std::vector<Rough> rough_runs() {
  std::vector<Rough> all;
  for (const auto* scheme : {"l1", "l1_2", "l2_1_sigma", "product_trapezoidal"}) {
    for (const auto* medium : {"even", "halves"}) {
      for (const bool graded : {false, true}) all.push_back({scheme, medium, graded});
    }
  }
  return all;
}

class RoughDiffusion : public testing::TestWithParam<Rough> {};
INSTANTIATE_TEST_SUITE_P(, RoughDiffusion, testing::ValuesIn(rough_runs()), [](const auto& test) {
  return test.param.scheme + "_" + test.param.medium + (test.param.graded ? "_graded" : "");
});

// A step contains all modes, and no grid in time resolves the fastest. At a fixed time these have decayed,
// and the rates are the theoretical ones for few unknowns: the start reduces the rate on uniform grids, and
// not on graded ones.
TEST_P(RoughDiffusion, HasTheRatesOfItsSingularStartAtAFixedTime) {
  const auto& [scheme_id, medium, graded] = GetParam();
  const Scheme& scheme = *find_scheme(scheme_id);
  for (const auto& [id, name, points] :
       {std::tuple{"fractional_diffusion", "components", 50.0}, {"fractional_diffusion_2d", "n", 12.0}}) {
    const Scene scene = scene_of(id, {{name, points}, {"start", "step"}, {"medium", medium}});
    const double grading = graded ? optimal_grading(scheme, scene.problem) : 1.0;
    const auto error = [&](int steps) {
      const auto path = scheme.solve(scene.problem, Grid{1.0, steps, grading}, {.output_times = {1.0}});
      return (columns_at(scene.outputs, 1.0, path.y.col(0)) - scene.reference.at(1.0).value)
          .cwiseAbs()
          .maxCoeff();
    };
    const double theory = scheme.expected_rate(scene.problem, scene.smoothness, grading, Norm::end);
    EXPECT_NEAR(std::log2(error(512) / error(1024)), theory, 0.06) << id << ", grading " << grading;
  }
}

}  // namespace
}  // namespace fde::bench
