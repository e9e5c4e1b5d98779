#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "weights/multistep.hpp"
#include "weights/polylogarithm.hpp"

namespace fde {

// The end values of a linear function on one step.
struct Ends {
  double left, right;
};

// How a rule weighs its past: a row of facts and functions, like a scheme. The order g in (0, 2] is that of
// the equation. A step reads y_n = past + kappa f(t_n, y_n), and the past sums w(k) x_j over the lags
// k = n - j >= 1, where the samples x are values of f or increments of y.
//
// A new family is one file, which defines its row, and one line of families.def. What it leaves empty is not
// done: without `coefficient` the past is summed as it stands, without `ends` all steps are equal, without
// `regular_part` there is no stability region.
struct WeightFamily {
  std::string_view id, title;

  // The samples are increments y_j - y_(j-1), and the rule integrates slopes of y with order 1 - g. Otherwise
  // they are values of f, which it integrates with order g.
  bool weighs_increments = false;

  // w(k) on equal steps, lag k >= 1. Extended, so that what is left in the end is the rounding to double.
  long double (*weight)(long double order, long double lag) = nullptr;

  // w(1), ..., w(count), where they are cheaper together. Empty: one by one.
  std::vector<long double> (*first_weights)(long double order, std::size_t count) = nullptr;

  // The weight of x_0 at step n >= 1. Empty: w(n).
  long double (*start_weight)(long double order, long double n) = nullptr;

  // The one value of all weights at order 1. Empty: they differ.
  std::optional<double> weight_at_order_one{};

  // kappa h^(-g) for a step of length h.
  long double (*step_factor)(long double order) = nullptr;

  // a, where the kernel t^(a-1)/Gamma(a) of the exponentials is not that of the order, and weights are
  // weighed and no differences. Empty: see kernel_exponent.
  long double (*exponent)(long double order) = nullptr;

  // The coefficient of exp(-node k) in w(k), where the kernel of the integral has the coefficient `kernel`
  // for exp(-node t); above order 1, in the difference w(k) - w(k-1). weight_transform.hpp has the formulas.
  double (*coefficient)(double order, double node, double kernel) = nullptr;

  // The same in start_weight. Empty: that is 0 or w(n).
  double (*start_coefficient)(double order, double node, double kernel) = nullptr;

  // phi_0 = 1, phi_1, ..., up to the last that counts: w is their convolution with the weights of
  // grunwald_letnikov. Then exponentials of these serve, and the family needs no coefficient.
  std::vector<double> (*filter)(double order) = nullptr;

  // w(k) = u(k) + (-1)^k v(k), each the weights of a family of its own, which has exponentials. Both or none.
  const WeightFamily *smooth_part = nullptr, *alternating_part = nullptr;

  // The rule as a multistep method, which start weights can make exact for more powers. Empty: it is none.
  const MultistepRule* multistep = nullptr;

  // (1-zeta)^g K(zeta), where K turns f into y. generating_function.hpp has the formulas.
  ComplexValue (*regular_part)(double order, ComplexValue log_zeta) = nullptr;

  // The linear function that replaces the integrand on a step of this length, from the samples at its ends;
  // `after` is 0 at the newest step of an implicit rule.
  Ends (*ends)(double before, double after, double length) = nullptr;
};

namespace families {

#define FDE_WEIGHT_FAMILY(id) extern const WeightFamily id;
#include "weights/families.def"
#undef FDE_WEIGHT_FAMILY

}  // namespace families
}  // namespace fde
