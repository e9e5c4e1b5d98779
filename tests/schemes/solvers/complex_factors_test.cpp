// SPDX-License-Identifier: MIT
// 1 - factor A with the variable medium of a square: real factors as a preconditioner, and complex ones.

#include "fdebench/schemes/solvers/complex_factors.hpp"

#include <gtest/gtest.h>

#include <Eigen/SparseLU>
#include <cmath>
#include <complex>

#include "fdebench/benchmarks/programs/large/step_matrix.hpp"

namespace fde::bench {
namespace {

// Diffusion in a medium that varies by three orders of magnitude: its eigenvalues are below 0.
SparseMatrix matrix_of_medium() {
  const auto medium = [](double x, double y) { return std::pow(1e3, x * std::sin(3.0 * y)); };
  return -step_matrix(40, 41, 1e3, medium, [](double, double) { return 0.0; });
}

ComplexVec scattered(Eigen::Index size) {
  return ComplexVec::NullaryExpr(size, [](Eigen::Index i) {
    const auto k = static_cast<double>(i);
    return std::complex{std::cos(997.0 * k * k), std::sin(991.0 * k * k)};
  });
}

// The error of a solution, relative to the largest entries of the terms of the equations.
double defect(const SparseMatrix& a, std::complex<double> factor, const ComplexVec& x, const ComplexVec& b) {
  const ComplexVec rest = b - x + factor * (a * x);
  const double size = 1.0 + std::abs(factor) * 8.0 * a.coeffs().abs().maxCoeff();
  return rest.lpNorm<Eigen::Infinity>() / (size * x.lpNorm<Eigen::Infinity>());
}

ComplexVec solved_by_lu(const SparseMatrix& a, std::complex<double> factor, const ComplexVec& b) {
  Eigen::SparseMatrix<std::complex<double>> matrix(a.rows(), a.cols());
  matrix.setIdentity();
  matrix -= factor * a.cast<std::complex<double>>();
  return Eigen::SparseLU<Eigen::SparseMatrix<std::complex<double>>>(matrix).solve(b);
}

TEST(ComplexFactors, OfAMediumAreRealOnes) {
  const SparseMatrix a = matrix_of_medium();
  const ComplexVec b = scattered(a.rows());
  for (const double size : {1e-6, 1e-3, 1.0}) {
    for (const double angle : {-1.2, 0.1, 1.0, 1.5}) {
      const auto factor = std::polar(size, angle);
      const auto factors = complex_factors(a, factor);
      ASSERT_TRUE(factors) << factor;
      ComplexVec x = b;
      factors->solve(x);
      const ComplexVec by_lu = solved_by_lu(a, factor, b);
      EXPECT_EQ(factors->name(), "cholesky") << factor;
      EXPECT_LT(defect(a, factor, x, b), 1e-14) << factor;
      EXPECT_LT((x - by_lu).norm(), 1e-9 * by_lu.norm()) << factor;
    }
  }
}

TEST(ComplexFactors, SolveAsAccuratelyAsTheirUseNeeds) {
  const SparseMatrix a = matrix_of_medium();
  const ComplexVec b = scattered(a.rows());
  for (const double angle : {1.0, 1.5}) {
    const auto factor = std::polar(0.01, angle);
    const ComplexVec exact = solved_by_lu(a, factor, b);
    double last = 1.0;
    for (const double accuracy : {1e-3, 1e-6, 1e-9}) {
      ComplexVec x = b;
      complex_factors(a, factor, accuracy)->solve(x);
      const double error = (x - exact).lpNorm<Eigen::Infinity>() / exact.lpNorm<Eigen::Infinity>();
      EXPECT_LT(error, accuracy) << factor;
      EXPECT_LT(error, 0.1 * last) << factor;
      last = error;
    }
  }
}

// Squares of such numbers are 0 or infinite.
TEST(ComplexFactors, SolveForRightHandSidesOfAnySize) {
  const SparseMatrix a = matrix_of_medium();
  const ComplexVec b = scattered(a.rows());
  const auto factors = complex_factors(a, {0.1, 0.2});
  ComplexVec x = b;
  factors->solve(x);
  for (const double size : {0x1p-600, 0x1p600}) {
    ComplexVec scaled = size * b;
    factors->solve(scaled);
    EXPECT_EQ(scaled, size * x) << size;
  }
}

// A growing mode makes the real matrix indefinite, and another entry makes it unsymmetric.
TEST(ComplexFactors, AreComplexWhereRealOnesDoNotApply) {
  SparseMatrix growing = matrix_of_medium(), other = growing;
  for (Eigen::Index i = 0; i < growing.rows(); ++i) growing.coeffRef(i, i) += 1e8;
  other.coeffRef(0, 700) = 1.0;
  other.makeCompressed();
  for (const SparseMatrix& a : {growing, other}) {
    const std::complex<double> factor{0.1, 0.2};
    const auto factors = complex_factors(a, factor);
    ASSERT_TRUE(factors);
    EXPECT_EQ(factors->name(), "lu");
    ComplexVec x = scattered(a.rows());
    const ComplexVec b = x;
    factors->solve(x);
    EXPECT_LT(defect(a, factor, x, b), 1e-14);
  }
}

}  // namespace
}  // namespace fde::bench
