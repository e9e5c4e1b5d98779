// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fdebench/reference/linear/linear_equation.hpp"
#include "fdebench/reference/linear/linear_system.hpp"
#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::bench {
namespace {

constexpr int reference_digits = 60;

// The largest ratio of error to bound, and the component that has it.
struct Worst {
  double ratio = 0.0;
  std::string row;

  void update(const reference::ReferenceValue& reference, const std::vector<reference::BigReal>& exact,
              const std::string& name) {
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const auto j = static_cast<Eigen::Index>(i);
      const auto error =
          reference::BigReal(abs(reference::BigReal(exact[i] - reference.value[j]))).convert_to<double>();
      const double now = error == 0.0 ? 0.0 : error / reference.bound[j];
      if (!(now <= ratio))
        *this = {now, fmt::format("{}: {:.17g} is off by {:.3g}", name, reference.value[j], error)};
    }
  }
};

reference::BigReal product(double a, double b) {
  return reference::from_shortest_decimal<reference::BigReal>(a) *
         reference::from_shortest_decimal<reference::BigReal>(b);
}

// x(t) of x' = A x, x(0) = (1, 0), with m = trace A / 2, h = (a11 - a22) / 2, r^2 = h^2 + a12 a21, each times
// t: x = e^m (cosh r + h sinh r / r, a21 t sinh r / r).
std::vector<reference::BigReal> exponential(const Matrix& matrix, double t) {
  const reference::BigReal a11 = product(matrix(0, 0), t), a22 = product(matrix(1, 1), t),
                           a21 = product(matrix(1, 0), t);
  const reference::BigReal half = (a11 - a22) / 2, square = half * half + product(matrix(0, 1), t) * a21;
  const reference::BigReal root = sqrt(reference::BigReal(abs(square))),
                           growth = exp(reference::BigReal((a11 + a22) / 2));
  const reference::BigReal even = square < 0 ? reference::BigReal(cos(root)) : reference::BigReal(cosh(root));
  const reference::BigReal odd = reference::BigReal(
      (square < 0 ? reference::BigReal(sin(root)) : reference::BigReal(sinh(root))) / root);
  return {growth * (even + half * odd), growth * a21 * odd};
}

void see_system(Worst& worst, const Matrix& matrix, double t) {
  const reference::Reference solution =
      reference::linear_reference(reference::LinearSystem{{1.0, 1.0}, {{1.0}, {0.0}}, matrix});
  worst.update(solution.at(t), exponential(matrix, t), fmt::format("system at {}", t));
}

void see_relaxation(Worst& worst, double lambda, double t) {
  const reference::Reference solution =
      reference::linear_reference({{{1.0, 1.0}, {-lambda, 0.0}}, {1.0}}, {0.0});
  worst.update(solution.at(t), {exp(product(lambda, t))}, fmt::format("e^({} * {})", lambda, t));
}

// u'' + w2 u = 0, u(0) = 1, u'(0) = 0, for either sign of w2.
void see_oscillator(Worst& worst, double w2, double t) {
  const reference::Reference solution =
      reference::linear_reference({{{1.0, 2.0}, {w2, 0.0}}, {1.0, 0.0}}, {0.0});
  const reference::BigReal angle =
      sqrt(reference::BigReal(abs(reference::from_shortest_decimal<reference::BigReal>(w2)))) *
      reference::from_shortest_decimal<reference::BigReal>(t);
  worst.update(solution.at(t), {w2 < 0.0 ? cosh(angle) : cos(angle)}, fmt::format("w2 = {} at {}", w2, t));
}

Matrix rotation(double re, double im) { return (Matrix(2, 2) << re, -im, im, re).finished(); }

// The bound of a double value holds for every log t, although the zeros of the characteristic function times
// t are differences of large logarithms.
class ExtremeTime : public testing::TestWithParam<double> {};

TEST_P(ExtremeTime, KeepsTheBoundWhereRateTimesTimeIsTen) {
  const reference::Precision precision(reference_digits);
  const double t = GetParam();
  Worst worst;
  see_relaxation(worst, 10.0 / t, t);
  see_system(worst, rotation(10.0 / t, 20.0 / t), t);
  if (std::abs(std::log10(t)) < 155.0) {  // w2 is a double
    see_oscillator(worst, 100.0 / t / t, t);
    see_oscillator(worst, -100.0 / t / t, t);
  }
  EXPECT_LE(worst.ratio, 1.0) << worst.row;
}

TEST_P(ExtremeTime, KeepsTheBoundAtRandomRates) {
  const reference::Precision precision(reference_digits);
  std::mt19937_64 random(
      20261121);  // NOLINT(bugprone-random-generator-seed,cert-msc51-cpp): the same rows each time
  std::uniform_real_distribution<double> unit(0.0, 1.0), both(-1.0, 1.0);
  Worst worst;
  for (int i = 0; i < 30; ++i) {
    const double t = GetParam() * (0.5 + unit(random)), size = std::pow(10.0, 2.5 * unit(random));
    const auto rate = [&] { return size * both(random) / t; };
    see_relaxation(worst, rate(), t);
    see_system(worst, rotation(rate(), rate()), t);
    see_system(worst, (Matrix(2, 2) << rate(), rate(), rate(), rate()).finished(), t);
    if (std::abs(std::log10(t)) < 150.0) see_oscillator(worst, rate() * (size / t), t);
  }
  EXPECT_LE(worst.ratio, 1.0) << worst.row;
}

INSTANTIATE_TEST_SUITE_P(LinearSolution, ExtremeTime,
                         testing::Values(1e300, 1e150, 1e80, 1e40, 1e12, 1.0, 1e-12, 1e-30, 1e-80, 1e-150,
                                         1e-290),
                         [](const auto& test) {
                           const double exponent = std::round(std::log10(test.param));
                           return fmt::format("Ten{}{}", exponent < 0 ? "Minus" : "", std::abs(exponent));
                         });

}  // namespace
}  // namespace fde::bench
