// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/prabhakar_and_matrix/mittag_leffler_matrix.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <boost/multiprecision/mpfr.hpp>
#include <stdexcept>
#include <unsupported/Eigen/MatrixFunctions>

#include "fdebench/reference/special_functions/prabhakar_and_matrix/mittag_leffler_matrix_quick.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar.hpp"
#include "support/testing.hpp"

namespace fde::reference {
namespace {

using Value = std::complex<double>;
using Eigen::MatrixXd;
using Precise = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<100>,
                                              boost::multiprecision::et_off>;

void expect_near(const MatrixValue& a, const ComplexMatrix& b, double off, const std::string& name) {
  EXPECT_LE((a.value - b).cwiseAbs().maxCoeff(), off) << name << ":\n" << a.value << "\nfor\n" << b;
  // entries that vanish are accurate relative to the largest entry
  const Eigen::ArrayXXd sizes = a.value.cwiseAbs();
  EXPECT_TRUE((a.bound.array() <= 1e-15 * (sizes == 0.0).select(sizes.maxCoeff(), sizes)).all())
      << name << "\n"
      << a.bound;
}

TEST(MittagLefflerOfAMatrix, OfOneRowIsThatOfANumber) {
  for (const Value z : {Value(-3.0), Value(1.0, 2.0), Value(0.0), Value(-1e8), Value(5.0, -7.0)}) {
    const auto number = mittag_leffler(0.75, 1.25, z);
    expect_near(mittag_leffler(0.75, 1.25, ComplexMatrix(ComplexMatrix::Constant(1, 1, z))),
                ComplexMatrix::Constant(1, 1, number.value), 2.0 * number.bound,
                fmt::format("{}{:+}i", z.real(), z.imag()));
  }
}

TEST(MittagLefflerOfAMatrix, OfOrderOneIsTheExponential) {
  MatrixXd a(3, 3);
  a << 1.0, 2.0, 0.5, -3.0, 0.25, 1.0, 0.0, -1.0, -2.0;
  expect_near(mittag_leffler(1.0, 1.0, a), a.exp().cast<Value>(), 1e-13, "exp");
}

// A = 4 s (P - I) with a projector P: E(A) = P + E(-4 s) (I - P), for any s. Eigenvalues are 0 and -4 s.
TEST(MittagLefflerOfAMatrix, OfASingularMatrixOfAnySize) {
  MatrixXd a(2, 2), projector(2, 2);
  a << -2.0, 1.0, 4.0, -2.0;
  projector << 0.5, 0.25, 1.0, 0.5;
  for (const double size : {1e20, 1e100, 1e300}) {
    expect_near(mittag_leffler(0.5, 1.0, MatrixXd(size * a)), projector.cast<Value>(), 1e-19,
                fmt::format("{}", size));
  }
}

// f(A) by divided differences; in the corner f[-1, -2, -3] - f[-1, -2, -3] = 0.
TEST(MittagLefflerOfAMatrix, MayHaveEntriesThatCancel) {
  const auto f = [](double x) { return mittag_leffler(0.5, 1.0, Value(x)).value.real(); };
  const double first = f(-1.0) - f(-2.0), second = f(-2.0) - f(-3.0);
  MatrixXd a(4, 4), known(4, 4);
  a << -1, 1, 1, 0, 0, -2, 0, 1, 0, 0, -2, -1, 0, 0, 0, -3;
  known << f(-1.0), first, first, 0, 0, f(-2.0), 0, second, 0, 0, f(-2.0), -second, 0, 0, 0, f(-3.0);
  const MatrixValue found = mittag_leffler(0.5, 1.0, a);
  expect_near(found, known.cast<Value>(), 1e-15, "triangular");
  EXPECT_EQ(mittag_leffler(0.5, 1.0, MatrixXd(a.transpose())).value, found.value.transpose());
}

// The entries of e^J for a Jordan block J of the eigenvalue 2 are e^2 / k!, in any basis.
TEST(MittagLefflerOfAMatrix, OfJordanBlocksInAnyBasis) {
  for (const int size : {4, 6}) {
    MatrixXd block = MatrixXd(2.0 * MatrixXd::Identity(size, size)), known = MatrixXd::Zero(size, size);
    MatrixXd basis = MatrixXd::Identity(size, size), inverse = basis;
    for (int i = 0; i < size; ++i) {
      for (int j = i; j < size; ++j) known(i, j) = std::exp(2.0) / std::tgamma(j - i + 1.0);
      if (i + 1 == size) break;
      block(i, i + 1) = 1.0;
      basis.row(i) += basis.row(i + 1);  // and then downwards, so that no entry of the basis is 0
      inverse.col(i + 1) -= inverse.col(i);
    }
    for (int i = 1; i < size; ++i) {
      basis.row(i) += basis.row(i - 1);
      inverse.col(i - 1) -= inverse.col(i);
    }
    ASSERT_EQ(basis * inverse, MatrixXd::Identity(size, size));
    expect_near(mittag_leffler(1.0, 1.0, MatrixXd(block.transpose())), known.transpose().cast<Value>(), 1e-13,
                "below the diagonal");
    const MatrixXd dense = basis * block * inverse, expected = basis * known * inverse;
    EXPECT_LE((mittag_leffler(1.0, 1.0, dense).value - expected).cwiseAbs().maxCoeff(), 1e-10) << dense;
  }
}

// E_2(-2 s) = cos sqrt(2 s) has an argument of 1e50: an exception, not a neglected contribution.
TEST(MittagLefflerOfAMatrix, RefusesEigenvaluesTooFarUp) {
  MatrixXd a(2, 2);
  a << -1.0, 1.0, 1.0, -1.0;
  EXPECT_THROW(mittag_leffler(2.0, 1.0, MatrixXd(1e100 * a)), std::runtime_error);
}

// A = L diag(-a^2) L^-1 and E_2(A) = L diag(cos a) L^-1, L with ones below the diagonal and L^-1 with the
// differences of rows. The contours round i a take as long as those near the real axis.
TEST(MittagLefflerOfAMatrix, OfOrderTwoMayHaveEigenvaluesFarUp) {
  const Precision precision(60);
  const std::vector<long> roots{1, 1000, 1000000, 3, 70};
  const auto similar = [&](const auto& diagonal, int i, int j) {
    BigReal entry(j <= i ? diagonal(roots[static_cast<std::size_t>(j)]) : BigReal(0));
    if (j + 1 <= i) entry -= diagonal(roots[static_cast<std::size_t>(j) + 1]);
    return entry;
  };
  std::vector<DecimalComplex> matrix;
  std::vector<BigReal> known;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      const BigReal entry = similar([](long a) { return BigReal(-BigReal(a) * a); }, i, j);
      matrix.push_back({to_text(entry, 40), "0", "0"});
      known.push_back(similar([](long a) { return BigReal(cos(BigReal(a))); }, i, j));
    }
  }
  const auto values = mittag_leffler("2", "1", matrix, 30);
  for (std::size_t i = 0; i < known.size(); ++i) {
    EXPECT_LE(abs(BigReal(BigReal(values[i].re) - known[i])), BigReal(values[i].bound)) << i;
    EXPECT_LE(BigReal(values[i].bound), 1e-29 * abs(known[i]) + 1e-32) << i;
  }
}

// Twelve rows, nearly defective: A = L (J + diag(0, d, 2d, ...)) L^-1 for a Jordan block J of the eigenvalue
// -2. E_1 = exp has the divided differences e^-2 (e^d - 1)^k / (k! d^k) for points d apart.
TEST(MittagLefflerOfAMatrix, MayBeNearlyDefective) {
  constexpr int rows = 12, digits = 25;
  const Precision precision(80);
  const BigReal apart("1e-8");
  // columns of L^-1 M: those of M; M L^-1: column j less column j + 1; L M: sums of rows
  const auto similar = [](std::vector<BigReal> m) {
    const auto at = [](int i, int j) {
      return static_cast<std::size_t>(i) * rows + static_cast<std::size_t>(j);
    };
    for (int i = 1; i < rows; ++i)
      for (int j = 0; j < rows; ++j) m[at(i, j)] += m[at(i - 1, j)];
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j + 1 < rows; ++j) m[at(i, j)] -= m[at(i, j + 1)];
    return m;
  };
  std::vector<BigReal> block, exponential;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows; ++j) {
      const int k = j - i;
      block.emplace_back(k == 0 ? BigReal(-2 + i * apart) : BigReal(k == 1 ? 1 : 0));
      const BigReal first = exp(BigReal(-2 + i * apart));
      exponential.emplace_back(
          k < 0 ? BigReal(0)
                : BigReal(first * pow(BigReal(expm1(apart) / apart), k) / gamma(BigReal(k + 1))));
    }
  }
  std::vector<DecimalComplex> matrix;
  for (const BigReal& entry : similar(block)) matrix.push_back({to_text(entry, 60), "0", "0"});
  const auto values = mittag_leffler("1", "1", matrix, digits);
  const auto known = similar(exponential);
  for (std::size_t i = 0; i < known.size(); ++i) {
    EXPECT_LE(abs(BigReal(BigReal(values[i].re) - known[i])), BigReal(values[i].bound)) << i;
    EXPECT_LE(BigReal(values[i].bound), 1e-24 * abs(known[i]) + 1e-50) << i;
  }
}

// V f(D) V^-1 with a V of small integers whose inverse is exact.
TEST(MittagLefflerOfAMatrix, ActsOnEigenvalues) {
  MatrixXd v(3, 3);
  v << 1.0, 2.0, 0.0, 0.0, 1.0, -3.0, 0.0, 0.0, 1.0;
  for (const double alpha : {0.4, 1.0, 1.7, 2.0}) {
    const Eigen::Vector3d eigenvalues(-4.0, 0.5, -0.75);
    const MatrixXd f =
        eigenvalues.unaryExpr([=](double x) { return mittag_leffler(alpha, 0.8, x); }).asDiagonal();
    const MatrixXd a = v * eigenvalues.asDiagonal() * v.inverse();
    expect_near(mittag_leffler(alpha, 0.8, a), (v * f * v.inverse()).cast<Value>(), 1e-14,
                fmt::format("alpha = {}", alpha));
  }
}

// f^(k)(lambda) / k! on the k-th upper diagonal.
TEST(MittagLefflerOfAMatrix, OfAJordanBlockHasItsDerivatives) {
  for (const Value eigenvalue : {Value(-1.5), Value(-2.0, 3.0), Value(0.0), Value(2.0)}) {
    for (const double alpha : {0.6, 1.0, 1.75}) {
      ComplexMatrix block = eigenvalue * ComplexMatrix::Identity(3, 3), exact = ComplexMatrix::Zero(3, 3);
      block(0, 1) = block(1, 2) = 1.0;
      for (int k = 0; k < 3; ++k) {
        exact.diagonal(k).setConstant(mittag_leffler_derivative(k, alpha, 1.0, eigenvalue).value /
                                      std::tgamma(k + 1.0));
      }
      expect_near(mittag_leffler(alpha, 1.0, block), exact, 1e-15 * exact.cwiseAbs().maxCoeff(),
                  fmt::format("alpha = {}", alpha));
    }
  }
}

// f[x, y] = (f(x) - f(y)) / (x - y) off the diagonal; stiff and highly nonnormal matrices.
TEST(MittagLefflerOfAMatrix, OfATriangleHasDividedDifferences) {
  struct Triangle {
    double first, second, beside;
  };
  for (const auto& [first, second, beside] :
       {Triangle{-1e8, -1.0, 1.0}, Triangle{-1.0, -2.0, 1e6}, Triangle{-1e-8, -1e12, 1e9}}) {
    for (const double alpha : {0.7, 1.5}) {
      MatrixXd a(2, 2);
      a << first, beside, 0.0, second;
      const double f = mittag_leffler(alpha, alpha, first), g = mittag_leffler(alpha, alpha, second);
      const auto computed = mittag_leffler(alpha, alpha, a);
      EXPECT_NEAR(computed.value(0, 0).real(), f, 4e-16 * std::abs(f));
      EXPECT_NEAR(computed.value(1, 1).real(), g, 4e-16 * std::abs(g));
      const double exact = beside * ((f - g) / (first - second));
      EXPECT_NEAR(computed.value(0, 1).real(), exact, 1e-14 * std::abs(exact)) << alpha;
      EXPECT_EQ(computed.value(1, 0), 0.0);
      EXPECT_TRUE((computed.bound.array() <= 1e-15 * computed.value.cwiseAbs().array() + 1e-16).all())
          << computed.bound;
    }
  }
}

TEST(MittagLefflerOfAMatrix, OfARotationIsAComplexNumber) {
  MatrixXd a(2, 2);
  a << -1.0, 3.0, -3.0, -1.0;
  const auto exact = mittag_leffler(1.3, 1.0, Value(-1.0, 3.0)).value;
  const auto value = mittag_leffler(1.3, 1.0, a).value;
  EXPECT_NEAR(value(0, 0).real(), exact.real(), 2e-16);
  EXPECT_NEAR(value(0, 1).real(), exact.imag(), 2e-16);
}

// Defective, 3 x 3, not triangular: P J P^-1 with exact P. The bound at 40 digits holds against 70 digits.
TEST(MittagLefflerOfAMatrix, BoundsItsErrorWhereItIsDefective) {
  std::vector<DecimalComplex> matrix;
  for (const char* entry : {"-2", "1", "0", "-1", "0", "1", "1", "-1", "-1"}) {
    matrix.push_back({entry, "0", "0"});
  }
  const auto few = mittag_leffler("0.6", "1", matrix, 40), many = mittag_leffler("0.6", "1", matrix, 70);
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_LE(abs(Precise(Precise(few[i].re) - Precise(many[i].re))), Precise(few[i].bound)) << i;
    EXPECT_LE(Precise(few[i].bound), 1e-38 * (abs(Precise(many[i].re)) + 1e-20)) << i;
  }
}

struct KnownMatrix {
  double alpha, beta;
  std::vector<Value> matrix, value;
};

// mpmath 1.3: the power series at 200 digits. Highly nonnormal, defective, complex, nearly singular matrices.
const std::vector<KnownMatrix> by_power_series{
    {0.75,
     1.0,
     {-2.0, 1.0, 0.5, -3.0},
     {0.22117069925160007104, 0.081750660757899789432, 0.040875330378949894716, 0.13942003849370028161}},
    {1.5,
     1.0,
     {-40.0, 64.0, 0.0, -8.0},
     {-0.009930965478693434638, -0.38588114752006945531, 0.0, -0.20287153923872816229}},
    {0.625,
     0.625,
     {-2.0, 1.0, 0.0, -1.0, 0.0, 1.0, 1.0, -1.0, -1.0},
     {0.045511087991657740341, 0.13491407924539492857, 0.1150559571199741192, -0.019858122125420809369,
      0.20028328936247347828, 0.24997003636536904777, 0.13491407924539492857, -0.13491407924539492857,
      0.065369210117078549711}},
    {1.75,
     1.25,
     {{-20.0, 3.0}, 4.0, 1.0, 2.0, -9.0, {0.0, -1.0}, 1.0, 1.0, -30.0},
     {{0.050066302568889368904, -0.08742712882718133887},
      {-0.15683159740280979976, -0.008774220155564632842},
      {-0.0087280722348683258859, -0.00044231893613804581634},
      {-0.077534512934066679532, -0.0030774488025890082391},
      {-0.38250505190297548674, 0.0057381592396710555358},
      {-0.0026502437756820668208, 0.024674241144237366423},
      {-0.012253215304221207271, -0.0056809640369112785438},
      {-0.029912886245010599151, 0.00087489929367081456455},
      {0.13784682305632212476, 0.0013149100646644310135}}},
    {0.5,
     1.0,
     {-4.0, 1.0, 0.0, 0.5, 2.0, -6.0, 1.0, 0.0, 0.0, 1.0, -3.0, 0.25, -1.0, 0.0, 0.5, -2.0},
     {0.14123896482944649382, 0.024637737094659383191, 0.011932100380891849794, 0.031661591245621392476,
      0.047120941999049556021, 0.10570746917979282442, 0.034398870618399784063, 0.013368455174404656702,
      0.0098104375243871165528, 0.032244338428130573701, 0.19172410786041080538, 0.022310826860500565885,
      -0.059014118110704364227, -0.0036237563175464943912, 0.036003524959924290321, 0.24711446965356867521}},
    {0.875,
     1.0,
     {0.5, 1.0, 1.0, 1.25},
     {3.6803462477307130839, 4.1289685530933472175, 4.1289685530933472175, 6.777072662550723497}}};

ComplexMatrix square(const std::vector<Value>& entries) {
  const auto rows = std::lround(std::sqrt(static_cast<double>(entries.size())));
  ComplexMatrix matrix(rows, rows);
  auto entry = entries.begin();
  for (auto row : matrix.rowwise()) {
    for (auto& x : row) x = *entry++;
  }
  return matrix;
}

TEST(MittagLefflerOfASmallMatrix, MeetsValuesFromAnIndependentSummation) {
  for (const auto& [alpha, beta, entries, values] : by_power_series) {
    const auto quick = mittag_leffler_matrix_quick(alpha, beta, square(entries));
    ASSERT_TRUE(quick) << alpha;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto& [value, error] = (*quick)[i];
      EXPECT_LE(std::abs(Value(value) - values[i]), static_cast<double>(error) + 2e-16 * std::abs(values[i]))
          << alpha << " entry " << i;
      EXPECT_LE(error, quick_tolerance * std::abs(value)) << alpha << " entry " << i;
    }
    const auto whole = mittag_leffler(alpha, beta, square(entries));
    EXPECT_TRUE(((whole.value - square(values)).cwiseAbs().array() <=
                 whole.bound.array() + 2e-16 * square(values).cwiseAbs().array())
                    .all())
        << alpha;
  }
}

// The bounds of the quick evaluation against 30 digits, for matrices of many sizes: small integers over 4,
// times a power of two. (Their decimals are exact.)
TEST(MittagLefflerOfASmallMatrix, StatesBoundsThatHold) {
  int quick_ones = 0;
  for (int n = 0; n < 48; ++n) {
    const int rows = 2 + n % 3;
    const double alpha = 0.25 * (1 + n % 7), beta = 0.5 * (1 + n % 4), size = std::ldexp(1.0, n % 8 - 3);
    ComplexMatrix matrix(rows, rows);
    std::vector<DecimalComplex> decimals;
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < rows; ++j) {
        const double re = size * ((i * 7 + j * 5 + n * 3) % 9 - (i == j ? 12 : 4)) / 4.0;
        const double im = n % 2 == 0 ? 0.0 : size * ((i * 3 + j * 4 + n) % 5 - 2) / 4.0;
        matrix(i, j) = {re, im};
        decimals.push_back({fmt::format("{}", re), fmt::format("{}", im), "0"});
      }
    }
    const auto quick = mittag_leffler_matrix_quick(alpha, beta, matrix);
    if (!quick) continue;
    ++quick_ones;
    const auto known = mittag_leffler(fmt::format("{}", alpha), fmt::format("{}", beta), decimals, 30);
    for (std::size_t i = 0; i < known.size(); ++i) {
      const Precise re = Precise(known[i].re) - Precise((*quick)[i].value.real()),
                    im = Precise(known[i].im) - Precise((*quick)[i].value.imag());
      EXPECT_LE(sqrt(Precise(re * re + im * im)), Precise((*quick)[i].error) + Precise(known[i].bound))
          << "matrix " << n << " entry " << i;
    }
  }
  EXPECT_GE(quick_ones, 40);
}

TEST(MittagLefflerOfAMatrix, HasZerosByStructureWithSmallBounds) {
  const std::vector<DecimalComplex> matrix{
      {"-1", "0", "0"}, {"2", "0", "0"}, {"0", "0", "0"}, {"-3", "0", "0"}};
  const auto value = mittag_leffler("0.5", "1", matrix, 20);
  EXPECT_EQ(value[2].re, "0");
  EXPECT_LE(Precise(value[2].bound), Precise("1e-20"));
}

TEST(MittagLefflerOfAMatrix, SaysWhereDigitsRunOut) {
  bench::expect_message(
      [] {
        mittag_leffler("0.5", "-2000.25", {{"-1", "0", "0"}}, 2);
      },
      "mittag_leffler of a matrix of 1 rows, alpha = 0.5, beta = -2000.25: no accurate value in reach");
}

TEST(MittagLefflerOfAMatrix, SaysWhatIsWrong) {
  const MatrixXd one = MatrixXd::Ones(2, 2);
  bench::expect_message([&] { mittag_leffler(0.0, 1.0, one); }, "alpha = 0 has to be in (0, 5]");
  bench::expect_message([&] { mittag_leffler(1.0, NAN, one); }, "beta = nan has to be in [-10000, 10000]");
  bench::expect_message(
      [] {
        mittag_leffler("0.5", "1e300", {{"1", "0", "0"}}, 10);
      },
      "beta = 1e+300 has to be in [-10000, 10000]");
  bench::expect_message([] { mittag_leffler(1.0, 1.0, MatrixXd(MatrixXd::Ones(2, 3))); },
                        "a matrix of 2 x 3 has to be square");
  bench::expect_message([] { mittag_leffler(1.0, 1.0, MatrixXd(MatrixXd::Zero(65, 65))); },
                        "has 65 rows, but has to have 1 to 64");
  bench::expect_message([&] { mittag_leffler(1.0, 1.0, MatrixXd(one * INFINITY)); },
                        "entries of the matrix have to be finite");
  bench::expect_message([&] { mittag_leffler(1.0, 1.0, MatrixXd(one * 1e3)); }, "entry 1 1 is beyond double");
  bench::expect_message(
      [] {
        mittag_leffler("1", "1", {{"one", "0", "0"}}, 10);
      },
      "entry: 'one' is not a finite decimal number");
}

}  // namespace
}  // namespace fde::reference
