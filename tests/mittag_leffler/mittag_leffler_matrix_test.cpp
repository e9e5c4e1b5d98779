#include "prabhakar_and_matrix/mittag_leffler_matrix.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <boost/multiprecision/mpfr.hpp>
#include <stdexcept>
#include <unsupported/Eigen/MatrixFunctions>

#include "prabhakar_and_matrix/prabhakar.hpp"
#include "support/testing.hpp"

namespace fde {
namespace {

using Value = std::complex<double>;
using Eigen::MatrixXd;
using Precise = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<100>,
                                              boost::multiprecision::et_off>;

void expect_near(const MatrixValue& a, const ComplexMatrix& b, double off, const std::string& name) {
  EXPECT_LE((a.value - b).cwiseAbs().maxCoeff(), off) << name << ":\n" << a.value << "\nfor\n" << b;
  // entries that vanish are known to what they were put together from
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

// A = s (P - I) 4 with a projector P: E(A) = P + E(-4 s) (I - P), for any s. Eigenvalues are 0 and -4 s.
TEST(MittagLefflerOfAMatrix, OfASingularMatrixOfAnySize) {
  MatrixXd a(2, 2), projector(2, 2);
  a << -2.0, 1.0, 4.0, -2.0;
  projector << 0.5, 0.25, 1.0, 0.5;
  for (const double size : {1e20, 1e100, 1e300}) {
    expect_near(mittag_leffler(0.5, 1.0, MatrixXd(size * a)), projector.cast<Value>(), 1e-19,
                fmt::format("{}", size));
  }
}

// E_2(-2 s) = cos sqrt(2 s) turns 1e50 times: refused, not left out.
TEST(MittagLefflerOfAMatrix, RefusesEigenvaluesTooFarUp) {
  MatrixXd a(2, 2);
  a << -1.0, 1.0, 1.0, -1.0;
  EXPECT_THROW(mittag_leffler(2.0, 1.0, MatrixXd(1e100 * a)), std::runtime_error);
}

// V f(D) V^-1 with a V of small whole numbers whose inverse is exact.
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

// f[x, y] = (f(x) - f(y)) / (x - y) beside the diagonal, stiff, and far from normal.
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

// Defective, 3 x 3, not triangular: P J P^-1 with exact P. To 40 digits the bound holds against 70.
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

TEST(MittagLefflerOfAMatrix, HasZerosByStructureWithSmallBounds) {
  const std::vector<DecimalComplex> matrix{
      {"-1", "0", "0"}, {"2", "0", "0"}, {"0", "0", "0"}, {"-3", "0", "0"}};
  const auto value = mittag_leffler("0.5", "1", matrix, 20);
  EXPECT_EQ(value[2].re, "0");
  EXPECT_LE(Precise(value[2].bound), Precise("1e-20"));
}

TEST(MittagLefflerOfAMatrix, SaysWhereDigitsRunOut) {
  expect_message(
      [] {
        mittag_leffler("0.5", "-2000.25", {{"-1", "0", "0"}}, 2);
      },
      "mittag_leffler of a matrix of 1 rows, alpha = 0.5, beta = -2000.25: no accurate value in reach");
}

TEST(MittagLefflerOfAMatrix, SaysWhatIsWrong) {
  const MatrixXd one = MatrixXd::Ones(2, 2);
  expect_message([&] { mittag_leffler(0.0, 1.0, one); }, "alpha = 0 has to be in (0, 5]");
  expect_message([&] { mittag_leffler(1.0, NAN, one); }, "beta = nan has to be in [-10000, 10000]");
  expect_message(
      [] {
        mittag_leffler("0.5", "1e300", {{"1", "0", "0"}}, 10);
      },
      "beta = 1e+300 has to be in [-10000, 10000]");
  expect_message([] { mittag_leffler(1.0, 1.0, MatrixXd(MatrixXd::Ones(2, 3))); },
                 "a matrix of 2 x 3 has to be square");
  expect_message([] { mittag_leffler(1.0, 1.0, MatrixXd(MatrixXd::Zero(65, 65))); },
                 "has 65 rows, but has to have 1 to 64");
  expect_message([&] { mittag_leffler(1.0, 1.0, MatrixXd(one * INFINITY)); },
                 "entries of the matrix have to be finite");
  expect_message([&] { mittag_leffler(1.0, 1.0, MatrixXd(one * 1e3)); }, "entry 1 1 is beyond double");
  expect_message(
      [] {
        mittag_leffler("1", "1", {{"one", "0", "0"}}, 10);
      },
      "entry: 'one' is not a finite decimal number");
}

}  // namespace
}  // namespace fde
