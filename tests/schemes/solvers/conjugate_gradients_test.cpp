// SPDX-License-Identifier: MIT
// Conjugate gradients preconditioned by fast sine transforms: the number of iterations does not depend on the
// number of points, results are as accurate as by Cholesky factors, and the factors take over where they are
// cheaper.

#include "fdebench/schemes/solvers/conjugate_gradients.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/programs/large/step_matrix.hpp"

namespace fde::bench {
namespace {

double none(double /*x*/, double /*y*/) { return 0.0; }
double one(double /*x*/, double /*y*/) { return 1.0; }
double smooth(double x, double y) { return 1.0 + 0.9 * std::sin(6.0 * x) * std::cos(5.0 * y); }
double far_apart(double x, double y) { return std::exp(4.6 * std::sin(3.0 * x + 2.0 * y)); }
double disc(double x, double y) { return std::hypot(x - 0.5, y - 0.5) < 0.3 ? 10.0 : 1.0; }
double thin(double /*x*/, double /*y*/) { return 0.01; }
// 3 u^2 - 1 of the Allen-Cahn equation, for a wave u.
double reaction(double x, double y) { return 3.0 * std::pow(std::sin(9.0 * x) * std::cos(7.0 * y), 2) - 1.0; }

struct GradientCase {
  std::string name;
  double (*diffusivity)(double, double);
  double (*reaction)(double, double);
  int most_iterations;
};

// For a jump of the diffusivity by 10 the bound of the theory is sqrt(10) / 2 log 2^54 = 59 iterations.
class Coefficients : public testing::TestWithParam<GradientCase> {
 protected:
  static SparseMatrix matrix(Eigen::Index n, Eigen::Index m) {
    return step_matrix(n, m, 0.03, GetParam().diffusivity, GetParam().reaction);
  }
};
INSTANTIATE_TEST_SUITE_P(, Coefficients,
                         testing::Values(GradientCase{"constant", one, none, 4},
                                         GradientCase{"smooth", smooth, none, 25},
                                         GradientCase{"far_apart", far_apart, none, 52},
                                         GradientCase{"jump", disc, none, 59},
                                         GradientCase{"reaction", thin, reaction, 12}),
                         [](const auto& test) { return test.param.name; });

Vec load(Eigen::Index size) {
  return Vec::LinSpaced(size, 0.0, 1.0).unaryExpr([](double x) {
    return std::cos(999.0 * x * x) + (x < 0.3 ? 1.0 : 0.0);
  });
}

TEST_P(Coefficients, TakeAsManyIterationsForAnyNumberOfPoints) {
  for (const auto& [n, m] : {std::pair{90, 90}, std::pair{45, 180}, std::pair{180, 180}}) {
    const SparseMatrix a = matrix(n, m);
    ConjugateGradients solver(a);
    ASSERT_TRUE(solver.factorise(a));
    Vec x = load(a.rows());
    solver.solve(x);
    EXPECT_LE(solver.iterations(), GetParam().most_iterations) << n;
    EXPECT_EQ(solver.active_method(), "conjugate_gradients");
  }
}

// The reference is the result of Cholesky factors with one step of iterative refinement.
TEST_P(Coefficients, AreSolvedAsWellAsByFactors) {
  const SparseMatrix a = matrix(90, 70);
  ConjugateGradients solver(a);
  ASSERT_TRUE(solver.factorise(a));
  CholeskyFactors factors(a);
  ASSERT_TRUE(factors.factorise(a));
  const Vec b = load(a.rows());
  Vec x = b, direct = b;
  solver.solve(x);
  factors.solve(direct);
  Vec correction = b - a * direct;
  factors.solve(correction);
  const Vec best = direct + correction;
  const auto error = [&](const Vec& y) {
    return (y - best).cwiseAbs().maxCoeff() / best.cwiseAbs().maxCoeff();
  };
  EXPECT_LT(error(x), std::max(4.0 * error(direct), 1e-14));
  EXPECT_LT(error(x), 2e-12);
}

// Squares of such numbers are 0 or infinite.
TEST_P(Coefficients, AreSolvedForRightHandSidesOfAnySize) {
  const SparseMatrix a = matrix(90, 70);
  Vec x = load(a.rows());
  ConjugateGradients solver(a);
  ASSERT_TRUE(solver.factorise(a));
  solver.solve(x);
  for (const double size : {0x1p-600, 0x1p600}) {
    Vec scaled = size * load(a.rows());
    ASSERT_TRUE(solver.factorise(a));
    solver.solve(scaled);
    EXPECT_EQ(scaled, size * x) << size;
  }
}

TEST(ConjugateGradients, GiveWayToFactorsWhenTheseWouldHaveCostLess) {
  const SparseMatrix a = step_matrix(60, 60, 0.03, smooth, none);
  ConjugateGradients solver(a);
  ASSERT_TRUE(solver.factorise(a));
  const Vec b = load(a.rows());
  Vec first = b;
  solver.solve(first);
  EXPECT_EQ(solver.active_method(), "conjugate_gradients");
  for (int again = 0; again < 10; ++again) {
    Vec x = b;
    solver.solve(x);
    EXPECT_LT((x - first).cwiseAbs().maxCoeff(), 1e-12);
  }
  EXPECT_EQ(solver.active_method(), "cholesky");
  // A new matrix resets the count of iterations.
  ASSERT_TRUE(solver.factorise(step_matrix(60, 60, 0.02, smooth, none)));
  EXPECT_EQ(solver.active_method(), "conjugate_gradients");
}

TEST(ConjugateGradients, RefuseIndefiniteMatrices) {
  const auto growth = [](double, double) { return -40.0; };
  const SparseMatrix a = step_matrix(60, 60, 0.03, smooth, growth);
  EXPECT_FALSE(ConjugateGradients(a).factorise(a));
}

TEST(ConjugateGradients, AreTakenForManyUnknownsAndCholeskysFactorsForFew) {
  const auto method = [](Eigen::Index n) {
    return std::string(sparse_factors(step_matrix(n, n, 0.03, smooth, none))->active_method());
  };
  EXPECT_EQ(method(44), "cholesky");
  EXPECT_EQ(method(45), "conjugate_gradients");
}

}  // namespace
}  // namespace fde::bench
