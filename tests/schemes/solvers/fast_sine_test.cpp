// SPDX-License-Identifier: MIT
// Constant coefficients in a rectangle are solved by sine transforms, in agreement with the known
// eigenvectors and with elimination.

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "fdebench/benchmarks/programs/large/step_matrix.hpp"
#include "fdebench/schemes/solvers/cholesky_factors.hpp"
#include "fdebench/schemes/solvers/complex_factors.hpp"
#include "fdebench/schemes/solvers/fast_sine_solver.hpp"
#include "fdebench/schemes/solvers/sparse_factors.hpp"

namespace fde::bench {
namespace {

using Complex = std::complex<double>;

Vec rough(Eigen::Index size) {
  return Vec::LinSpaced(size, 0.0, 1.0).unaryExpr([](double x) {
    return std::cos(999.0 * x * x) + (x < 0.3 ? 1.0 : 0.0);
  });
}

double relative_distance(const Vec& one, const Vec& other) {
  return (one - other).cwiseAbs().maxCoeff() / other.cwiseAbs().maxCoeff();
}

class Length : public testing::TestWithParam<Eigen::Index> {};
// 101, 127 and 317 intervals are primes.
INSTANTIATE_TEST_SUITE_P(SineTransform, Length, testing::Values(2, 3, 8, 9, 100, 126, 127, 316),
                         testing::PrintToStringParamName());

TEST_P(Length, TransformsModesToWholeNumbersAndBack) {
  const Eigen::Index n = GetParam();
  const SineTransform transform(n);
  const auto mode = [&](Eigen::Index k) -> Vec {
    return Vec::LinSpaced(n, 1.0, static_cast<double>(n)).unaryExpr([&](double i) {
      return std::sin(std::numbers::pi * i * static_cast<double>(k) / static_cast<double>(n + 1));
    });
  };
  Matrix fields(n, 3), modes(transform.rows(), 3), back(n, 3);
  fields << mode(1), mode(2), mode(n);
  transform.forward(fields.data(), modes);
  const double half = static_cast<double>(n + 1) / 2.0;
  const auto row_of = [&](Eigen::Index k) {
    return k % 2 == 1 ? k / 2 : ((n + 1) / 2 + 7) / 8 * 8 + k / 2 - 1;
  };
  for (const Eigen::Index column : {0, 1, 2}) {
    const Eigen::Index k = column < 2 ? column + 1 : n;
    Vec expected = Vec::Zero(transform.rows());
    expected[row_of(k)] = half;
    EXPECT_LT((modes.col(column) - expected).cwiseAbs().maxCoeff(), 1e-13 * half) << k;
  }
  transform.backward(modes, back.data());
  EXPECT_LT((back - fields).cwiseAbs().maxCoeff(), 1e-13);
}

TEST_P(Length, IsSolvedAsByElimination) {
  const Eigen::Index n = GetParam();
  for (const auto& [along, across] :
       {std::pair{n, Eigen::Index{7}}, std::pair{Eigen::Index{5}, n}, std::pair{n, n}}) {
    if (along * across > 20'000) continue;
    const SparseMatrix matrix = step_matrix(along, across, 0.03);
    const auto factors = sparse_factors(matrix);
    ASSERT_EQ(factors->active_method(), "fast_sine");
    CholeskyFactors cholesky(matrix);
    ASSERT_TRUE(cholesky.factorise(matrix));
    Vec one = rough(matrix.rows()), other = one;
    factors->solve(one);
    cholesky.solve(other);
    EXPECT_LT(relative_distance(one, other), 1e-12) << along << " x " << across;
  }
}

TEST(FastSineSolver, SolvesForEigenvectorsByTheirEigenvalues) {
  constexpr Eigen::Index n = 12, m = 31;
  const FastSineSolver sines(n, m);
  const Stencil<double> stencil{5.0, -1.5, -0.5};
  const Stencil<Complex> complex{{5.0, 2.0}, {-1.5, -0.5}, {-0.5, 0.25}};
  const auto wave = [](Eigen::Index points, int k) {
    const auto angle = std::numbers::pi * k / static_cast<double>(points + 1);
    return Vec(Vec::LinSpaced(points, 1.0, static_cast<double>(points)).unaryExpr([=](double i) {
      return std::sin(i * angle);
    }));
  };
  for (const auto& [k, l] : {std::pair{1, 1}, std::pair{2, 31}, std::pair{12, 5}}) {
    const Vec mode = (wave(n, k) * wave(m, l).transpose()).reshaped();
    const auto eigenvalue = [&, of_n = std::cos(std::numbers::pi * k / 13.0),
                             of_m = std::cos(std::numbers::pi * l / 32.0)](const auto& s) {
      return s.diagonal + 2.0 * of_n * s.line_coupling + 2.0 * of_m * s.cross_coupling;
    };
    Vec real = mode;
    sines.solve(stencil, real);
    EXPECT_LT((real - mode / eigenvalue(stencil)).cwiseAbs().maxCoeff(), 1e-14);
    ComplexVec pair = mode.cast<Complex>();
    sines.solve(complex, pair);
    EXPECT_LT((pair - mode.cast<Complex>() / eigenvalue(complex)).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST(FastSineSolver, IsRecognisedFromTheEntries) {
  const SparseMatrix matrix = step_matrix(9, 6, 0.1);
  const auto with = [&](Eigen::Index i, Eigen::Index k, double value) {
    SparseMatrix other = matrix;
    other.coeffRef(i, k) = value;
    if (i != k) other.coeffRef(k, i) = value;
    other.makeCompressed();
    return std::string(sparse_factors(other)->active_method());
  };
  EXPECT_EQ(sparse_factors(matrix)->active_method(), "fast_sine");
  const double own = matrix.coeff(7, 7);
  EXPECT_EQ(with(7, 7, own * (1.0 + 1e-15)), "fast_sine");  // equal up to rounding
  EXPECT_EQ(with(7, 7, own * (1.0 + 1e-13)), "cholesky");
  EXPECT_EQ(with(7, 8, matrix.coeff(7, 8) * 1.001), "cholesky");
  EXPECT_EQ(with(8, 9, -1e-3), "cholesky");  // couples the end of a line with the beginning of the next
  EXPECT_EQ(with(0, 20, -1e-3), "cholesky");
}

// (1, 1) is the first mode of 1 - kappa (A + c) to become negative, c the growth.
TEST(FastSineSolver, KnowsTheSignOfItsDeterminant) {
  for (const Eigen::Index m : {6, 7}) {
    const SparseMatrix matrix = step_matrix(5, m, 0.2);
    for (const double growth : {0.0, 3.0, 8.0, 50.0, 1e3, 1e5}) {
      SparseMatrix other = matrix;
      other.diagonal().array() -= growth;
      const double expected = Matrix(other).determinant();
      EXPECT_EQ(sparse_factors(other)->determinant_sign(), expected > 0.0 ? 1 : -1) << m << ' ' << growth;
    }
  }
}

TEST(FastSineSolver, RefusesUnstableElimination) {
  SparseMatrix indefinite = step_matrix(9, 6, 0.1);
  const auto factors = sparse_factors(indefinite);
  indefinite.diagonal().array() -= 20.0;
  EXPECT_FALSE(factors->factorise(indefinite));
  EXPECT_EQ(sparse_factors(indefinite)->active_method(), "lu");
}

struct ComplexCase {
  std::string method;
  SparseMatrix matrix;
};
class ComplexMatrixOf : public testing::TestWithParam<ComplexCase> {};
INSTANTIATE_TEST_SUITE_P(
    , ComplexMatrixOf,
    testing::Values(ComplexCase{"tridiagonal",
                                Matrix(step_matrix(2, 9, 0.1)).topLeftCorner(2, 2).sparseView()},
                    ComplexCase{"fast_sine", step_matrix(7, 9, 0.1)},
                    ComplexCase{"lu", step_matrix(
                                          7, 9, 0.1, [](double x, double) { return 1.0 + x; },
                                          [](double, double) { return 0.0; })}),
    [](const auto& test) { return test.param.method; });

// The matrices 1 - factor A have dominant diagonals for the first factor only; with the others 1 is between
// the eigenvalues of the real part.
TEST_P(ComplexMatrixOf, IsSolvedAsByDenseElimination) {
  const auto& [method, matrix] = GetParam();
  for (const Complex factor : {Complex(-0.5, -0.24), Complex(0.3, 0.6), Complex(0.2, -1.4)}) {
    const auto factors = complex_factors(matrix, factor);
    if (factor.real() < 0.0 || method == "fast_sine") {
      ASSERT_EQ(factors->name(), method);
    }
    const ComplexMatrix dense =
        ComplexMatrix::Identity(matrix.rows(), matrix.rows()) - factor * Matrix(matrix).cast<Complex>();
    ComplexVec b = rough(matrix.rows()).cast<Complex>() * Complex(1.0, 0.5);
    const ComplexVec expected = dense.partialPivLu().solve(b);
    factors->solve(b);
    EXPECT_LT((b - expected).cwiseAbs().maxCoeff(), 1e-13) << factor;
  }
}

}  // namespace
}  // namespace fde::bench
