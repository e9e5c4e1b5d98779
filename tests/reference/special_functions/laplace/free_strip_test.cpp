// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/laplace/free_strip.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fdebench/reference/special_functions/laplace/contour.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/quick_contours.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar.hpp"

namespace fde::reference {
namespace {

struct StripCase {
  const char* name;
  double alpha, beta, gamma;
  std::complex<double> z;
};

class OnCoarseShiftedContours : public testing::TestWithParam<StripCase> {};

// The trapezoidal sum at 60 digits, so that its error is the discretisation error.
BigComplex trapezoidal_sum(const StripCase& x, const ShiftedShape& shape) {
  const Contour<BigReal> contour(shape.mu, shape.omega, shape.depth, false);
  const BigReal alpha(x.alpha), beta(x.beta), gamma(x.gamma), offset(shape.offset);
  const BigComplex z(x.z.real(), x.z.imag());
  const auto transform = [&](const BigComplex& s) {
    const BigComplex log_s = log(s), difference = BigReal(1) - z * exp(BigComplex(-alpha * log_s));
    return BigComplex(exp(BigComplex(-beta * log_s - gamma * log(difference))));
  };
  BigComplex sum(0);
  for (const auto& node : contour.nodes()) {
    const BigComplex s = node.s + offset, weight = node.weight * exp(offset);
    sum += weight * transform(s) + conj(weight) * transform(conj(s));
  }
  return sum;
}

// All singularities are inside, so that the only error is the discretisation error.
TEST_P(OnCoarseShiftedContours, WhatIsNeglectedIsBounded) {
  const StripCase& x = GetParam();
  const auto text = [](double number) { return fmt::format("{}", number); };
  const auto exact =
      prabhakar(text(x.alpha), text(x.beta), text(x.gamma), text(x.z.real()), text(x.z.imag()), 45);
  const SingularityRoots roots(x.alpha, std::log(x.z), -max_sheet);
  const SingularityFreeStrip::Factor factor = roots.factor(x.gamma);
  int bounded = 0;
  for (const ShiftedShape& shape :
       {ShiftedShape{0.0, 6.0, 40.0, 40.0}, ShiftedShape{0.0, 16.0, 90.0, 50.0},
        ShiftedShape{-14.0, 30.0, 150.0, 30.0}, ShiftedShape{-14.0, 30.0, 250.0, 30.0},
        ShiftedShape{-44.0, 60.0, 500.0, 12.0}}) {
    const auto strip = SingularityFreeStrip(shape).bound_for(
        {.exponent = x.alpha * x.gamma - x.beta, .alpha = x.alpha, .factors = {&factor, 1}});
    if (!strip || strip->outside) continue;
    ++bounded;
    const Precision precision(60);
    const BigComplex off = trapezoidal_sum(x, shape) - BigComplex(BigReal(exact.re), BigReal(exact.im));
    EXPECT_LE(log(norm1(off)).convert_to<double>(), strip->log_bound + std::numbers::ln2)
        << "mu = " << shape.mu << ", omega = " << shape.omega;
  }
  EXPECT_GE(bounded, 2);
}

INSTANTIATE_TEST_SUITE_P(SingularityFreeStrip, OnCoarseShiftedContours,
                         testing::Values(StripCase{"NoSingularity", 0.5, 1.0, 1.5, -1.0},
                                         StripCase{"FarUp", 1.75, 1.0, 1.5, -100.0},
                                         StripCase{"OnTheImaginaryAxis", 2.0, 1.0, 0.5, -100.0},
                                         StripCase{"OnTheRealAxis", 0.5, 1.0, 1.25, 1.5},
                                         StripCase{"NextToTheCut", 1.0078125, 1.0, 1.5, -5.0},
                                         StripCase{"OneOfTwo", 1.5, 1.0, 2.5, {-12.0, 9.0}},
                                         StripCase{"NegativeBeta", 0.75, -2.25, 3.5, -2.0},
                                         StripCase{"LargeBeta", 1.25, 6.5, 0.75, -2.0},
                                         StripCase{"Large", 0.75, 1.0, 1.5, -4096.0}),
                         [](const testing::TestParamInfo<StripCase>& test) { return test.param.name; });

}  // namespace
}  // namespace fde::reference
