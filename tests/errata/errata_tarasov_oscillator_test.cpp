// SPDX-License-Identifier: MIT
// Tarasov & Zaslavsky 2006, the one-dimensional example: eqs 47-50, as printed and corrected.

#include <gtest/gtest.h>

#include "fdebench/reference/linear/linear_equation.hpp"
#include "fdebench/reference/linear/linear_system.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "support/caputo.hpp"

namespace fde::bench {
namespace {

// The one-dimensional example with a1/b1 = 2 and these initial values, at this time.
constexpr double alpha = 2.5, ratio = 2.0, q0 = 1.0, q1 = 0.5, q2 = 0.3, time_of_test = 1.3, constant = q1;
enum Row : Eigen::Index { position, velocity, d_three_halves, acceleration };

// Eq. 46, q' + (b/a) D^(5/2) q = C0, as a chain of D^(1/2) from q' on.
Vec one_dimensional_example() {
  Matrix links = Matrix::Zero(4, 4);
  links(position, velocity) = links(velocity, d_three_halves) = links(d_three_halves, acceleration) = 1.0;
  links(acceleration, velocity) = -ratio;
  return reference::linear_reference(reference::LinearSystem{.orders = {1.0, 0.5, 0.5, 0.5},
                                                             .initial = {{q0}, {q1}, {0.0}, {q2}},
                                                             .matrix = links,
                                                             .loads = {{}, {}, {}, {{ratio * constant}}}})
      .at(time_of_test)
      .value;
}

// q = q0 + q1 t + q2 t^2 E_{3/2,3}(-2 t^(3/2)), so that D^(3/2) q = q2 t^(1/2) E_{3/2,3/2}.
TEST(TarasovOneDimensionalExample, HasAClosedForm) {
  const double t = time_of_test, z = -ratio * std::pow(t, alpha - 1.0);
  const Vec now = one_dimensional_example();
  EXPECT_NEAR(now[position], q0 + q1 * t + q2 * t * t * reference::mittag_leffler(alpha - 1.0, 3.0, z),
              1e-14);
  EXPECT_NEAR(now[d_three_halves], q2 * std::sqrt(t) * reference::mittag_leffler(alpha - 1.0, 1.5, z), 1e-14);
}

TEST(ErrataTarasov, Equation47HasTheWrongInitialValueInItsBoundaryTerm) {
  const double t = time_of_test, z = -ratio * std::pow(t, alpha - 1.0);
  const double rate = q2 / std::sqrt(t) * reference::mittag_leffler(alpha - 1.0, 0.5, z);  // d/dt D^(3/2) q
  const double left = one_dimensional_example()[velocity] + rate / ratio;
  EXPECT_NEAR(left, 0.574224049799008, 1e-14);
  // m = 3, and the power of t belongs to q''(0).
  EXPECT_NEAR(constant + std::pow(t, 2.0 - alpha) / reference::gamma(3.0 - alpha) * q2 / ratio, left, 1e-14);
  const auto printed = [=](double m) {
    return constant + std::pow(t, m - alpha) / reference::gamma(m - alpha + 1.0) * q0 / ratio;
  };
  EXPECT_NEAR(printed(3.0), 1.14327509825807, 1e-13);
  EXPECT_NEAR(printed(2.0), 0.747413499330026, 1e-13);
}

TEST(ErrataTarasov, Equation48HasTheWrongForce) {
  const double t = time_of_test;
  const Vec now = one_dimensional_example();
  const double left = now[d_three_halves] + ratio * now[position];
  EXPECT_NEAR(left, 3.68596505895484, 1e-13);
  EXPECT_NEAR(q2 * std::pow(t, 3.0 - alpha) / reference::gamma(4.0 - alpha) + ratio * (q0 + q1 * t), left,
              1e-13);
  const auto boundary = [=](double m) {
    return std::pow(t, m - alpha + 1.0) / reference::gamma(m - alpha + 2.0) * q0;
  };
  const double line = ratio * (constant * t + q0);  // C1 t + C2, C2 from t = 0
  EXPECT_NEAR(boundary(3.0) + line, 4.41501017031399, 1e-13);
  EXPECT_NEAR(boundary(2.0) + line, 4.58655019651614, 1e-13);
  // q = 1 solves 44; the error of the printed 48 is then its boundary term.
  EXPECT_NEAR(boundary(3.0), 1.115, 1e-3);
  EXPECT_NEAR(boundary(2.0), 1.287, 1e-3);
}

// D^(3/2) q + 4 q = 1 from rest at t = 1, and the convolution with the kernel by quadrature.
TEST(ErrataTarasov, Equation50LacksTheFactorOneOverOmegaSquared) {
  const double nu = 1.5, w2 = 4.0, t = 1.0;
  const double exact = reference::linear_reference(
                           reference::LinearEquation{{{1.0, nu}, {w2, 0.0}}, {0.0, 0.0}, {{1.0}}}, {0.0})
                           .at(t)
                           .value[0];
  EXPECT_NEAR(exact, 0.318106219727485, 1e-14);
  const auto kernel = [&](double s) { return reference::mittag_leffler(nu, nu, -w2 * std::pow(s, nu)); };
  const double convolution = integral(kernel, 0.0, t, nu - 1.0);
  EXPECT_NEAR(convolution, exact, 1e-12);
  const double printed = w2 * convolution;  // -int q0' with q0' = -w2 s^(nu-1) E_{nu,nu}
  EXPECT_NEAR(printed, 1.0 - reference::mittag_leffler(nu, 1.0, -w2 * std::pow(t, nu)), 1e-12);
  EXPECT_NEAR(printed, 1.27242487890994, 1e-12);
}

// w2 = a1/b1 of 49 in another unit of time, t = c t': q(c t') has the coefficient w2 c^nu.
TEST(ErrataTarasov, Equation49HasAFrequencyWithADimension) {
  const auto at = [](double w2, double t) {
    return reference::linear_reference(reference::LinearEquation{{{1.0, 1.5}, {w2, 0.0}}, {1.0, 0.0}}, {0.0})
        .at(t)
        .value[0];
  };
  const double c = 3.0, q = at(2.0, c * 0.7);
  EXPECT_NEAR(at(2.0 * std::pow(c, 1.5), 0.7), q, 1e-14);
  EXPECT_GT(std::abs(at(2.0, 0.7) - q), 0.1);
  EXPECT_GT(at(-2.0, c * 0.7), 10.0);  // and a1/b1 < 0 is no oscillator
}

}  // namespace
}  // namespace fde::bench
