// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <limits>

#include "fdebench/reference/special_functions/laplace/contour.hpp"
#include "fdebench/reference/special_functions/laplace/contour_bound.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/decimal_arguments.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/multiprecision.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/quick.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/quick_contours.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/tiny_order.hpp"
#include "fdebench/reference/special_functions/numbers/bounded.hpp"

namespace fde::reference {

namespace {

constexpr double log_of_nothing = -750.0;  // half the smallest double is e^-745.1

// For beta >= 2, Gamma(beta + x) >= Gamma(beta) (beta-1)^x, so |E| <= 1/Gamma(beta) / (1-q) with
// q = |z| / (beta-1)^alpha. For alpha <= 1, E is int e^(z u) d mu(u) with a positive measure mu (Schneider
// 1996: complete monotonicity), so |E(z)| <= E(Re z), which increases with Re z.
bool vanishes_by_series(double alpha, double beta, std::complex<double> z) {
  const double size = alpha <= 1.0 ? std::max(z.real(), 0.0) : std::abs(z);
  return size <= 0.5 * std::pow(beta - 1.0, alpha);
}

// Residues are at most (1/alpha) e^(Re s*) |s*|^(1-beta).
double log_residue(const QuickArguments& x, const Pole<double>& pole) {
  constexpr double most_log = 600.0, rounding = 1e-14;  // of arg s*
  const double log_size = std::min(pole.log.real(), most_log);
  return std::exp(log_size) * (std::cos(pole.log.imag()) + rounding) + (1.0 - x.beta.hi) * log_size -
         std::log(x.alpha);
}

// Whether the integral along the parabola s = mu (1 + i x)^2 and the residues to its right are negligible.
bool vanishes_on(const QuickArguments& x, double mu) {
  constexpr double most_log = 600.0, log_of_poles = 3.0;
  PerSheet<std::complex<double>> roots;
  bool residues_vanish = true;
  for (const auto& pole : x.poles.on_near_sheets) {
    const double log_modulus = 0.5 * std::min(pole.log.real() - std::log(mu), most_log);
    roots.push_back(std::polar(std::exp(log_modulus), 0.5 * pole.log.imag()));
    if (ContourBound::includes_residue(roots.back(), 1.0))
      residues_vanish = residues_vanish && log_residue(x, pole) + log_of_poles < log_of_nothing;
  }
  return residues_vanish &&
         ContourBound::log_integral(mu, 1.0,
                                    {.exponent = x.alpha - x.beta.hi,
                                     .alpha = x.alpha,
                                     .log_size = x.log_size(),
                                     .nearest_other_argument = x.poles.nearest_other_argument,
                                     .roots = {roots.data(), roots.size()}}) < log_of_nothing;
}

// Whether |E_{alpha,beta}(z)|, Im z >= 0, is certainly below half the smallest positive double, as
// 1/Gamma(beta) is for a large beta.
bool certainly_underflows(double alpha, double beta, std::complex<double> z) {
  constexpr double smallest = 180.0;  // 2 / Gamma(180) = 1e-327
  if (beta < smallest) return false;
  if (z == 0.0 || vanishes_by_series(alpha, beta, z)) return true;
  const QuickArguments x(alpha, {beta, 0.0}, z);
  // For s > 0, e^s s^-beta is smallest at s = beta. A pole may be too near one of these parabolas.
  return std::ranges::any_of(std::array{1.0, 0.25, 4.0},
                             [&](double part) { return vanishes_on(x, part * beta); });
}

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
