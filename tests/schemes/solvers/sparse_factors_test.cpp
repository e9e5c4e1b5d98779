// SPDX-License-Identifier: MIT
// A sparse matrix is factorised by the fastest applicable method, and the results equal those of dense
// elimination.

#include "fdebench/schemes/solvers/sparse_factors.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>
#include <vector>

#include "fdebench/schemes/history/parallel_for_rows.hpp"

namespace fde::bench {
namespace {

// 1 - kappa times second differences on n points, or n x n.
Matrix diffusion(int n, bool square, double kappa) {
  const int size = square ? n * n : n;
  Matrix a = Matrix::Identity(size, size);
  const auto couple = [&](int i, int j) {
    a(i, i) += kappa;
    a(i, j) -= kappa;
  };
  for (int i = 0; i < size; ++i) {
    if (i % n > 0) couple(i, i - 1);
    if (i % n < n - 1) couple(i, i + 1);
    if (i >= n) couple(i, i - n);
    if (i + n < size) couple(i, i + n);
  }
  return a;
}

Matrix with(Matrix a, int row, int column, double value) {
  a(row, column) = value;
  return a;
}

struct FactorCase {
  std::string name, method;
  Matrix matrix;
  int sign = 1;
};

std::vector<FactorCase> factor_cases() {
  const Matrix line = diffusion(9, false, 3.0), square = diffusion(5, true, 3.0);
  return {{"line", "tridiagonal", line},
          {"wind", "tridiagonal", with(line, 3, 4, -0.5)},
          {"negative_row", "tridiagonal", with(line, 0, 0, -8.0), -1},
          {"weak_diagonal", "cholesky", with(with(line, 3, 4, -4.2), 4, 3, -4.2)},
          {"square", "cholesky", square},
          {"indefinite", "lu", with(square, 7, 7, -40.0), -1},
          {"not_symmetric", "lu", with(square, 3, 9, 0.5)},
          {"exchanged_rows", "lu", (Matrix(2, 2) << 0.0, 1.0, 1.0, 0.0).finished(), -1}};
}

class SparseMatrixOf : public testing::TestWithParam<FactorCase> {};
INSTANTIATE_TEST_SUITE_P(, SparseMatrixOf, testing::ValuesIn(factor_cases()),
                         [](const auto& test) { return test.param.name; });

TEST_P(SparseMatrixOf, IsSolvedByTheQuickestMethodThatMay) {
  const auto& [name, method, matrix, sign] = GetParam();
  const auto factors = sparse_factors(matrix.sparseView());
  ASSERT_NE(factors, nullptr);
  EXPECT_EQ(factors->active_method(), method);
  const Vec x = Vec::LinSpaced(matrix.rows(), -1.0, 2.0);
  Vec b = matrix * x;
  factors->solve(b);
  EXPECT_LT((b - x).cwiseAbs().maxCoeff(),
            1e-14 * matrix.inverse().cwiseAbs().rowwise().sum().maxCoeff() * 50.0);
}

TEST_P(SparseMatrixOf, HasTheSignOfItsDeterminant) {
  const auto factors = sparse_factors(GetParam().matrix.sparseView());
  EXPECT_EQ(factors->determinant_sign(), GetParam().sign);
  EXPECT_EQ(factors->determinant_sign(), GetParam().matrix.determinant() > 0.0 ? 1 : -1);
}

TEST(SparseFactors, AreRecomputedForTheSamePattern) {
  for (const bool square : {false, true}) {
    const auto factors = sparse_factors(diffusion(5, square, 3.0).sparseView());
    const Matrix other = diffusion(5, square, 0.25);
    ASSERT_TRUE(factors->factorise(other.sparseView()));
    const Vec x = Vec::LinSpaced(other.rows(), -1.0, 2.0);
    Vec b = other * x;
    factors->solve(b);
    EXPECT_LT((b - x).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST(SparseFactors, DoNotServeWhereTheyWouldLoseDigits) {
  const Matrix square = diffusion(5, true, 3.0);
  const auto cholesky = sparse_factors(square.sparseView());
  EXPECT_FALSE(cholesky->factorise(with(square, 7, 7, -40.0).sparseView()));
  const Matrix line = diffusion(9, false, 3.0);
  const auto tridiagonal = sparse_factors(line.sparseView());
  EXPECT_FALSE(tridiagonal->factorise(with(line, 4, 4, 1e-9).sparseView()));
}

TEST(SparseFactors, AreNoneOfASingularMatrixOrOneThatIsNotFinite) {
  const Matrix square = diffusion(5, true, 3.0);
  Matrix singular = square;
  singular.row(3).setZero();
  EXPECT_EQ(sparse_factors(singular.sparseView()), nullptr);
  EXPECT_EQ(sparse_factors(Matrix(with(square, 3, 3, std::numeric_limits<double>::quiet_NaN())).sparseView()),
            nullptr);
}

// Elimination from both ends meets in the middle, also where an end is short or missing.
TEST(TridiagonalFactors, SolveSystemsOfAnySize) {
  for (int n = 1; n <= 12; ++n) {
    const Matrix matrix = diffusion(n, false, 2.0);
    const Vec exact = Vec::LinSpaced(n, 1.0, 3.0);
    Vec x = matrix * exact;
    const auto factors = sparse_factors(matrix.sparseView());
    ASSERT_EQ(factors->active_method(), "tridiagonal");
    factors->solve(x);
    EXPECT_LE((x - exact).lpNorm<Eigen::Infinity>(), 1e-14) << n;
    EXPECT_EQ(factors->determinant_sign(), 1);
  }
}

TEST(SparseFactors, HaveTheSameBitsInAnyNumberOfThreads) {
  for (const bool square : {false, true}) {
    const int n = square ? 200 : 40'000, size = square ? n * n : n;
    SparseMatrix matrix(size, size);
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < size; ++i) {
      entries.emplace_back(i, i, square ? 13.0 : 7.0);
      if (i % n > 0) entries.emplace_back(i, i - 1, -3.0);
      if (i % n < n - 1) entries.emplace_back(i, i + 1, -3.0);
      if (square && i >= n) entries.emplace_back(i, i - n, -3.0);
      if (square && i + n < size) entries.emplace_back(i, i + n, -3.0);
    }
    matrix.setFromTriplets(entries.begin(), entries.end());
    const auto factors = sparse_factors(matrix);
    EXPECT_EQ(factors->active_method(), square ? "fast_sine" : "tridiagonal");
    const Vec exact = Vec::LinSpaced(size, 1.0, 3.0);
    const auto solution = [&](int threads) {
      const RowThreads several(threads);
      Vec x = matrix * exact;
      factors->solve(x);
      return x;
    };
    const Vec one = solution(1);
    EXPECT_LE((one - exact).lpNorm<Eigen::Infinity>(), 1e-12);
    for (const int threads : {2, 3}) EXPECT_EQ(one, solution(threads)) << threads;
  }
}

}  // namespace
}  // namespace fde::bench
