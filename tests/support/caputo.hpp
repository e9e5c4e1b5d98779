// SPDX-License-Identifier: MIT
#pragma once

// Fractional calculus directly from the definitions; only Gamma is taken from the library.

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>

#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::bench {

using Function = std::function<double(double)>;

// int_from^to f(s) (s - from)^at_from (to - s)^at_to ds, exponents above -1, by GSL. Throws
// std::runtime_error if its error estimate is above 1e-11, relative to 1 + |value|.
inline double integral(const Function& f, double from, double to, double at_from = 0.0, double at_to = 0.0) {
  constexpr std::size_t intervals = 2000;
  gsl_set_error_handler_off();
  const std::unique_ptr<gsl_integration_qaws_table, decltype(&gsl_integration_qaws_table_free)> powers(
      gsl_integration_qaws_table_alloc(at_from, at_to, 0, 0), gsl_integration_qaws_table_free);
  const std::unique_ptr<gsl_integration_workspace, decltype(&gsl_integration_workspace_free)> workspace(
      gsl_integration_workspace_alloc(intervals), gsl_integration_workspace_free);
  gsl_function integrand{[](double s, void* of) { return (*static_cast<const Function*>(of))(s); },
                         const_cast<Function*>(&f)};
  double value = 0.0, error = 0.0;
  gsl_integration_qaws(&integrand, from, to, powers.get(), 1e-14, 1e-13, intervals, workspace.get(), &value,
                       &error);
  if (!(error <= 1e-11 * (1.0 + std::abs(value)))) {
    throw std::runtime_error(fmt::format("the integral {} is off by {}", value, error));
  }
  return value;
}

// D^order x^power from 0, a fractional integral for order < 0; 0 for an integer power below the order.
inline double caputo_derivative_of_power(double power, double order, double x) {
  if (reference::is_integer(power) && power < order) return 0.0;
  return reference::gamma(power + 1.0) * reference::reciprocal_gamma(power + 1.0 - order) *
         std::pow(x, power - order);
}

// J^order f from 0 to t of f(s) = s^start over_power(s), with over_power smooth.
inline double fractional_integral(const Function& over_power, double order, double t, double start = 0.0) {
  return integral(over_power, 0.0, t, start, order - 1.0) * reference::reciprocal_gamma(order);
}

// tD_to^order f with the sign (-1)^m and the kernel (s - t)^(m - order - 1); derivative is f^(m), m =
// ceil(order).
inline double right_caputo(const Function& derivative, double order, double t, double to) {
  const double m = std::ceil(order);
  return std::pow(-1.0, m) * integral(derivative, t, to, m - order - 1.0) *
         reference::reciprocal_gamma(m - order);
}

// The right Riemann-Liouville derivative for orders in (0, 1); at_end: the value of the function at `to`.
inline double right_riemann_liouville(const Function& derivative, double at_end, double order, double t,
                                      double to) {
  return right_caputo(derivative, order, t, to) +
         at_end * std::pow(to - t, -order) * reference::reciprocal_gamma(1.0 - order);
}

}  // namespace fde::bench
