// SPDX-License-Identifier: MIT
// Agrawal's extremum against quadrature of its integral and the case alpha = 1, and its smoothness where the
// series changes.

#include "fdebench/reference/linear/closed_forms/extremum.hpp"

#include <gsl/gsl_integration.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::reference {
namespace {

using Workspace = std::unique_ptr<gsl_integration_workspace, decltype(&gsl_integration_workspace_free)>;
using Table = std::unique_ptr<gsl_integration_qaws_table, decltype(&gsl_integration_qaws_table_free)>;

// int_a^b f(s) (s - a)^p (b - s)^q ds.
double quadrature(double a, double b, double p, double q, double (*f)(double, void*), void* parameters) {
  const Workspace workspace(gsl_integration_workspace_alloc(1000), gsl_integration_workspace_free);
  const Table table(gsl_integration_qaws_table_alloc(p, q, 0, 0), gsl_integration_qaws_table_free);
  gsl_function function{f, parameters};
  double result = 0.0, error = 0.0;
  gsl_integration_qaws(&function, a, b, table.get(), 1e-14, 1e-13, 1000, workspace.get(), &result, &error);
  return result;
}

class OfOrder : public testing::TestWithParam<double> {};

// The singular factor (t - s)^(alpha-1) is the weight, (1 - s)^(alpha-1) the integrand.
TEST_P(OfOrder, IsItsIntegral) {
  double alpha = GetParam();
  const Reference extremum = extremum_reference(alpha);
  for (const double t : {1e-3, 0.25, 0.5, 0.51, 0.75, 0.95}) {
    const auto factor = [](double s, void* order) {
      return std::pow(1.0 - s, *static_cast<double*>(order) - 1.0);
    };
    const double integral = quadrature(0.0, t, 0.0, alpha - 1.0, factor, &alpha);
    const ReferenceValue known = extremum.at(t);
    EXPECT_NEAR(known.value[0], (2.0 * alpha - 1.0) * integral, 1e-12 * known.value[0]) << t;
    EXPECT_LE(known.bound[0], 2e-16 * known.value[0]) << t;
    const double derivative = (2.0 * alpha - 1.0) * std::tgamma(alpha) * std::pow(1.0 - t, alpha - 1.0);
    EXPECT_NEAR(known.value[1], derivative, 4e-15 * derivative) << t;
  }
}

TEST_P(OfOrder, HasItsEndsAndBothSeriesMeet) {
  const Reference extremum = extremum_reference(GetParam());
  EXPECT_EQ(extremum.at(0.0).value[0], 0.0);
  EXPECT_EQ(extremum.at(1.0).value[0], 1.0);
  EXPECT_EQ(extremum.at(1.0).value[1], std::numeric_limits<double>::infinity());
  EXPECT_EQ(extremum.digits(1.0, 30)[0].value, "1.00000000000000000000000000000");
  // y(1/2 + h) - 2 y(1/2) + y(1/2 - h) ~ h^2: no jump where the series changes.
  const Precision precision(60);
  const auto value = [&](double t) { return BigReal(extremum.digits(t, 45)[0].value); };
  const BigReal h("1e-15"), second = value(0.500000000000001) - 2 * value(0.5) + value(0.499999999999999);
  EXPECT_LE(abs(second), 20 * h * h);
}

INSTANTIATE_TEST_SUITE_P(Extremum, OfOrder, testing::Values(0.50390625, 0.55, 0.6, 0.75, 0.9, 0.999999));

TEST(Extremum, IsAStraightLineForOrderOne) {
  const Reference extremum = extremum_reference(1.0);
  for (const double t : {0.0, 0.1, 0.5, 0.7, 1.0}) {
    EXPECT_EQ(extremum.at(t).value[0], t);
    EXPECT_EQ(extremum.at(t).value[1], 1.0);
  }
}

// Near t = 1: 1 - y ~ Gamma(alpha) Gamma(2 - 2 alpha) / Gamma(1 - alpha) (1 - t)^(2 alpha - 1).
TEST(Extremum, LeavesItsEndLikeAPower) {
  const Precision precision(60);
  const BigReal y(extremum_reference(0.6).digits(0.999999999999999, 40)[0].value), left("1e-15");
  const BigReal first =
      gamma(BigReal("0.6")) * gamma(BigReal("0.8")) / gamma(BigReal("0.4")) * pow(left, BigReal("0.2"));
  // the next term is -0.1 (1 - t)
  EXPECT_LE(abs(BigReal(1 - y - first - BigReal("0.1") * left)), BigReal("1e-29"));
}

TEST(Extremum, RefusesWhatIsOutside) {
  for (const double alpha : {0.5, 1.25, std::nan("")})
    EXPECT_THROW(extremum_reference(alpha), std::invalid_argument);
  const Reference extremum = extremum_reference(0.75);
  for (const double t : {-0.1, 1.5, std::nan("")}) EXPECT_THROW(extremum.at(t), std::invalid_argument);
  EXPECT_THROW(extremum.digits(0.5, 0), std::invalid_argument);
}

}  // namespace
}  // namespace fde::reference
