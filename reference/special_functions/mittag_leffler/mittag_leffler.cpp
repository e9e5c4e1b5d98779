// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "fdebench/reference/special_functions/laplace/contour.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/decimal_arguments.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/multiprecision.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/quick.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/tiny_order.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/underflow.hpp"
#include "fdebench/reference/special_functions/numbers/adaptive_precision.hpp"

namespace fde::reference {
namespace {

using Arguments = MittagLefflerArguments;

constexpr const char* function_name = "mittag_leffler";

// A lower bound of |z E'|, by alpha z E'_{alpha,beta}(z) = E_{alpha,beta-1}(z) - (beta-1) E_{alpha,beta}(z).
long double least_slope(double alpha, double beta, std::complex<double> z, const QuickValue& value) {
  const auto before = mittag_leffler_quick(alpha, exact_sum(beta, -1.0), z);
  if (!before) return 0.0L;
  const long double factor = static_cast<long double>(beta) - 1.0L;
  const long double error = before->error + std::abs(factor) * value.error;
  return (std::abs(before->value - factor * value.value) - error) / alpha;
}

bool meets_tolerance(double alpha, double beta, std::complex<double> z, const QuickValue& value) {
  return value.error <= quick_tolerance * std::abs(value.value) ||
         value.error <= quick_tolerance * least_slope(alpha, beta, z, value);
}

MittagLefflerValue upper_half_plane(double alpha, double beta, std::complex<double> z) {
  if (certainly_underflows(alpha, beta, z)) return {0.0, std::numeric_limits<double>::denorm_min()};
  if (const auto value = mittag_leffler_tiny_order_out_of_range(alpha, beta, z))
    return {value->value, value->bound};
  const bool real = z.imag() == 0.0;
  const auto quick = mittag_leffler_quick(alpha, {beta, 0.0}, z);
  if (quick && meets_tolerance(alpha, beta, z, *quick)) {
    const auto [value, bound] = to_double(quick->value, quick->error);
    return {real ? std::complex(value.real()) : value, bound};
  }
  const Precision precision(contour_precision(double_digits));
  const auto read = [&] { return Arguments{BigReal(alpha), BigReal(beta), BigComplex(z.real(), z.imag())}; };
  const auto [value, bound] =
      to_double(mittag_leffler_multiprecision(double_digits, decimal_places(alpha, beta), read));
  return {real ? std::complex(value.real()) : value, bound};
}

// Whether alpha is below 1e-30 and E proportional to it, as it is if beta is a zero of 1/Gamma,
//   E_{alpha,beta}(z) = alpha (1/Gamma)'(beta) z/(1-z)^2 (1 + O(alpha)),
// and no pole s^alpha = z is near. The value then has the relative rounding error of alpha.
bool is_proportional_to_order(double alpha, double beta, std::complex<double> z) {
  return alpha <= 1e-30 && beta <= 0.0 && beta >= -170.0 && std::floor(beta) == beta &&
         (z.real() <= 0.5 || std::abs(z) <= 0.5);
}

}  // namespace

MittagLefflerValue mittag_leffler(double alpha, double beta, std::complex<double> z) {
  require_order(function_name, alpha);
  require_parameter(function_name, "beta", beta);
  require_finite(function_name, z);
  if (z.imag() >= 0.0) return upper_half_plane(alpha, beta, std::complex(z.real(), std::abs(z.imag())));
  const MittagLefflerValue mirrored = upper_half_plane(alpha, beta, std::conj(z));
  return {std::conj(mirrored.value), mirrored.bound};
}

double mittag_leffler(double alpha, double beta, double z) {
  return mittag_leffler(alpha, beta, std::complex<double>(z)).value.real();
}

DecimalComplex mittag_leffler(const std::string& alpha, const std::string& beta, const std::string& re,
                              const std::string& im, int digits) {
  require_digits(function_name, digits);
  const auto read = [&] {
    return Arguments{parse_argument(function_name, "alpha", alpha),
                     parse_argument(function_name, "beta", beta), parse_complex(function_name, re, im)};
  };
  const Precision precision(contour_precision(digits));
  const Arguments x = read();
  require_order(function_name, x.alpha);
  require_parameter(function_name, "beta", x.beta);
  const int places = std::max(decimal_places(alpha), decimal_places(beta));
  return to_decimal_complex(mittag_leffler_multiprecision(digits, places, read), x.real(), digits);
}

MittagLefflerValue mittag_leffler_in_double(const std::string& alpha, const std::string& beta,
                                            const std::string& re, const std::string& im) {
  constexpr int guard_digits = 3;
  const auto order = exact_double(alpha), parameter = exact_double(beta), x = exact_double(re),
             y = exact_double(im);
  if (parameter && x && y) {
    const std::complex<double> z(*x, *y);
    if (order) return mittag_leffler(*order, *parameter, z);
    const double near = std::strtod(alpha.c_str(), nullptr);
    if (near >= std::numeric_limits<double>::min() && is_proportional_to_order(near, *parameter, z)) {
      const auto [value, bound] = mittag_leffler(near, *parameter, z);
      return {value, bound + std::numeric_limits<double>::epsilon() * std::abs(value)};
    }
  }
  return rounded_to_double(mittag_leffler(alpha, beta, re, im, double_digits + guard_digits));
}

}  // namespace fde::reference
