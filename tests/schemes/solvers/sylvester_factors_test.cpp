// SPDX-License-Identifier: MIT
// X - A X K^T = B is solved as by elimination with the assembled matrix 1 - K x A, for matrices K with real,
// complex, multiple and defective eigenvalues in both half planes.

#include "fdebench/schemes/solvers/sylvester_factors.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "fdebench/benchmarks/programs/large/step_matrix.hpp"

namespace fde::bench {
namespace {

// Numbers without a pattern.
Matrix scattered(Eigen::Index rows, Eigen::Index columns) {
  return Matrix::NullaryExpr(rows, columns, [=](Eigen::Index i, Eigen::Index j) {
    const auto k = static_cast<double>(i + rows * j);
    return std::cos(997.0 * k * k + k);
  });
}

Matrix with_eigenvalues(const Matrix& blocks) {
  const Matrix vectors = scattered(blocks.rows(), blocks.rows());
  return vectors * blocks * vectors.inverse();
}

std::vector<Matrix> small_matrices() {
  Matrix pairs = Matrix::Zero(5, 5), negative = pairs, jordan = pairs;
  pairs << 1.0, 0.7, 0, 0, 0, -0.7, 1.0, 0, 0, 0, 0, 0, 0.5, 40.0, 0, 0, 0, -0.01, 0.5, 0, 0, 0, 0, 0, 0.2;
  negative << -0.3, 0.6, 0, 0, 0, -0.6, -0.3, 0, 0, 0, 0, 0, -0.2, 1.4, 0, 0, 0, -1.4, -0.2, 0, 0, 0, 0, 0,
      0.1;
  jordan.diagonal().setConstant(0.4);
  jordan.diagonal(1).setConstant(0.3);
  return {Matrix::Constant(1, 1, 0.7), scattered(2, 2), with_eigenvalues(pairs),
          with_eigenvalues(negative),  jordan,          scattered(8, 8).cwiseAbs()};
}

struct LargeMatrix {
  std::string method;
  SparseMatrix matrix;
};

// Second differences, and the same with scattered coefficients.
std::vector<LargeMatrix> large_matrices() {
  const SparseMatrix one = step_matrix(7, 9, 1.0);
  SparseMatrix square(63, 63);
  square.setIdentity();
  square = 0.05 * (square - one);
  SparseMatrix line = square.topLeftCorner(7, 7), other = square;
  other.coeffRef(3, 40) = other.coeffRef(20, 1) = 0.6;
  line.makeCompressed();
  other.makeCompressed();
  return {{"tridiagonal", line}, {"fast_sine", square}, {"lu", other}};
}

class Sylvester : public testing::TestWithParam<LargeMatrix> {};
INSTANTIATE_TEST_SUITE_P(, Sylvester, testing::ValuesIn(large_matrices()),
                         [](const auto& test) { return test.param.method; });

TEST_P(Sylvester, EquationsAreSolvedAsByDenseElimination) {
  const auto& a = GetParam().matrix;
  const Matrix dense = a;
  for (const Matrix& k : small_matrices()) {
    const Eigen::Index size = k.rows() * a.rows();
    Matrix assembled = Matrix::Identity(size, size);
    for (Eigen::Index i = 0; i < k.rows(); ++i) {
      for (Eigen::Index j = 0; j < k.rows(); ++j)
        assembled.block(i * a.rows(), j * a.rows(), a.rows(), a.rows()) -= k(i, j) * dense;
    }
    const Eigen::PartialPivLU<Matrix> factors(assembled);
    SylvesterFactors sylvester;
    ASSERT_TRUE(sylvester.factorise(a, k));
    EXPECT_EQ(sylvester.determinant_sign(), factors.determinant() > 0.0 ? 1 : -1) << k;
    const Vec exact = scattered(size, 1);
    Vec x = assembled * exact;
    sylvester.solve(x);
    EXPECT_LT((x - exact).norm() / exact.norm(), 1e-14 / factors.rcond()) << k;
  }
}

TEST_P(Sylvester, EquationsAreSolvedByTheFastestComplexMethod) {
  SylvesterFactors sylvester;
  ASSERT_TRUE(sylvester.factorise(GetParam().matrix, small_matrices()[2]));
  EXPECT_EQ(sylvester.method(), GetParam().method);
}

TEST(SylvesterFactors, OfASingularMatrixAreRefused) {
  SparseMatrix a(2, 2);
  a.insert(0, 0) = 2.0;
  a.insert(1, 1) = -1.0;
  SylvesterFactors sylvester;
  EXPECT_TRUE(sylvester.factorise(a, Matrix::Constant(1, 1, 1.0)));
  EXPECT_FALSE(sylvester.factorise(a, Matrix::Constant(1, 1, 0.5)));
  EXPECT_FALSE(sylvester.factorise(a, Matrix::Constant(1, 1, std::nan(""))));
}

}  // namespace
}  // namespace fde::bench
