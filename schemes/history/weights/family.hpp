// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "fdebench/schemes/history/weights/multistep_rule.hpp"
#include "fdebench/schemes/history/weights/polylogarithm.hpp"

namespace fde {

// The values of a linear function at both ends of a step.
struct EndpointValues {
  double left, right;
};

// A family of convolution weights, given by constants and functions of the order g in (0, 2] of the equation.
// A step is y_n = memory + kappa f(t_n, y_n), where the memory term sums w(k) x_j over the lags k = n - j >=
// 1 and the samples x are values of f or increments of y.
//
// A new family is one file that defines it and one line of families.def. Empty members limit its use: without
// `coefficient` (or `filter`, or the two parts) sums are direct, without `endpoint_values` all steps are
// equal, without `regular_part` there is no stability region.
struct WeightFamily {
  std::string_view id, title;

  // True: the samples are increments y_j - y_(j-1), and the rule integrates the slope of y with order 1 - g.
  // False: the samples are values of f, and the rule integrates f with order g.
  bool acts_on_increments = false;

  // w(k) on equal steps, lag k >= 1, in extended precision, so that the result is correct up to the rounding
  // to double.
  long double (*weight)(long double order, long double lag) = nullptr;

  // w(1), ..., w(count), for families with a cheap recurrence. Empty: `weight` is called for each.
  std::vector<long double> (*first_weights)(long double order, std::size_t count) = nullptr;

  // The weight of x_0 at step n >= 1. Empty: w(n).
  long double (*first_sample_weight)(long double order, long double n) = nullptr;

  // The common value of all weights at order 1. Empty: they are not equal.
  std::optional<double> weight_at_order_one{};

  // kappa h^(-g) for a step of length h.
  long double (*step_factor)(long double order) = nullptr;

  // The exponent a of the kernel t^(a-1)/Gamma(a) of the exponentials, where it does not follow from the
  // order; the exponentials then give the weights and not their differences. Empty: see kernel_exponent.
  long double (*exponent)(long double order) = nullptr;

  // The coefficient of exp(-node k) in w(k), for orders above 1 in w(k) - w(k-1), where `kernel` is the
  // coefficient of exp(-node t) in the kernel. Formulas: exponential_sum.hpp.
  double (*coefficient)(double order, double node, double kernel) = nullptr;

  // The same for first_sample_weight. Empty: the weight of x_0 is 0 or w(n).
  double (*first_sample_coefficient)(double order, double node, double kernel) = nullptr;

  // phi_0 = 1, phi_1, ..., up to the last that is not negligible: w is the convolution of phi with the
  // weights of grunwald_letnikov, whose exponentials are used; then `coefficient` is not needed.
  std::vector<double> (*filter)(double order) = nullptr;

  // The families of u and v in w(k) = u(k) + (-1)^k v(k); both have exponentials. Both or none are set.
  const WeightFamily *smooth_part = nullptr, *alternating_part = nullptr;

  // The rule as a fractional linear multistep method, for starting weights. Empty: it is none.
  const MultistepRule* multistep = nullptr;

  // (1-zeta)^g K(zeta), where y = K f for generating functions. Formulas: generating_function.hpp.
  ComplexValue (*regular_part)(double order, ComplexValue log_zeta) = nullptr;

  // The linear function that replaces the integrand on a step of this length, from the samples at its ends;
  // `after` is 0 at the newest step of an implicit rule.
  EndpointValues (*endpoint_values)(double before, double after, double length) = nullptr;
};

namespace families {

#define FDE_WEIGHT_FAMILY(id) extern const WeightFamily id;
#include "fdebench/schemes/history/weights/families.def"
#undef FDE_WEIGHT_FAMILY

}  // namespace families
}  // namespace fde
