// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar_quick.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "fdebench/reference/special_functions/mittag_leffler/quick_contours.hpp"

namespace fde::reference {
namespace {

using Value = std::complex<long double>;

long double to_long(const DoubleDouble& x) { return static_cast<long double>(x.hi) + x.lo; }

bool meets_tolerance(const QuickValue& x) { return x.error <= quick_tolerance * std::abs(x.value); }

// A bound of the sum of the terms from `next` on, as in prabhakar_transform.cpp; size: the modulus of the
// first of them without 1/Gamma.
std::optional<long double> tail(double alpha, long double argument, double gamma, int next, long double size,
                                long double modulus) {
  constexpr long double slow = 0.9L, largest_reciprocal = 1.13L;
  const long double growing = gamma + next;
  if (argument < 2.0L || growing <= 0.0L) return std::nullopt;
  const long double ratio = modulus * std::max(1.0L, growing / (next + 1)) *
                            std::pow(argument - 1.0L, -static_cast<long double>(alpha));
  if (ratio > slow) return std::nullopt;
  return size * largest_reciprocal / (1.0L - ratio);
}

QuickValue with_factor(const QuickValue& x, const Value& factor, long double relative_error) {
  const Value value = x.value * factor;
  return {value, norm1(factor) * x.error + (relative_error + few_ulps) * norm1(value)};
}

// The coefficients of E_{alpha,beta-j} in z^k d^k/dz^k E_{alpha,beta} = theta (theta - 1) ... (theta - k + 1)
// E, theta = z d/dz; and the sums of the moduli of their terms.
struct Shifts {
  std::vector<long double> coefficients, sizes;
};
Shifts shifts_of(int k, double alpha, long double beta) {
  Shifts shifts{{1.0L}, {1.0L}};
  const long double order = alpha;
  for (int m = 0; m < k; ++m) {
    Shifts next{std::vector<long double>(shifts.coefficients.size() + 1), {}};
    next.sizes = next.coefficients;
    for (std::size_t j = 0; j < shifts.coefficients.size(); ++j) {
      const long double lower =
          (beta - static_cast<long double>(j) - 1.0L) / order + static_cast<long double>(m);
      const long double lower_size =
          (std::abs(beta) + static_cast<long double>(j) + 1.0L) / order + static_cast<long double>(m);
      next.coefficients[j + 1] += shifts.coefficients[j] / order;
      next.coefficients[j] -= shifts.coefficients[j] * lower;
      next.sizes[j + 1] += shifts.sizes[j] / order;
      next.sizes[j] += shifts.sizes[j] * lower_size;
    }
    shifts = std::move(next);
  }
  return shifts;
}

std::optional<QuickValue> by_recurrence(int k, double alpha, const DoubleDouble& beta,
                                        std::complex<double> z) {
  const auto [coefficients, sizes] = shifts_of(k, alpha, to_long(beta));
  QuickValue sum{0.0L, 0.0L};
  for (std::size_t j = 0; j < coefficients.size(); ++j) {
    const auto value = mittag_leffler_quick(alpha, beta + DoubleDouble{-static_cast<double>(j), 0.0}, z);
    if (!value) return std::nullopt;
    sum = sum + QuickValue{coefficients[j] * value->value, std::abs(coefficients[j]) * value->error +
                                                               few_ulps * sizes[j] * norm1(value->value)};
  }
  Value factor = 1.0L;
  for (int m = 1; m <= k; ++m) factor /= static_cast<long double>(m) * Value(z);
  return with_factor(sum, factor, 4.0L * static_cast<long double>(k) * few_ulps);
}

struct PrabhakarParameters {
  double alpha;
  DoubleDouble beta;
  double gamma;
};

// Logarithm of a bound of the contribution of an s* right of the strip, which is neglected; infinite in the
// right half-plane. The contribution is the integral of e^s F around a cut from s* radially outward. With
// u = alpha (log s - log s*) the path is at a distance delta from u >= 0, so
// |s^alpha - z| >= max(|s|^alpha, |z|) delta / 10 and |F| <= |s|^-beta (delta/10)^-gamma, and
// Re s <= -kappa |s|. The smallest bound over several delta: e^s favours a path next to the cut, F a wide
// one.
double log_neglected_singularity(const PrabhakarParameters& x, const std::complex<double>& log_pole) {
  constexpr double quarter = std::numbers::pi / 2.0, infinity = std::numeric_limits<double>::infinity();
  const double turn = std::abs(log_pole.imag()), beta = x.beta.hi;
  double least = infinity;
  for (double part = 0.5; part > 1e-3; part *= 0.25) {
    const double delta = std::min(1.0, part * x.alpha * (turn - quarter)), off = delta / x.alpha;
    if (!(delta > 0.0)) return infinity;
    const double kappa = std::min(-std::cos(turn - off), -std::cos(turn + off));
    const double log_nearest = log_pole.real() - off, nearest = std::exp(log_nearest);
    const double rate = kappa - std::max(0.0, -beta) / nearest;
    if (!(rate > 0.0)) continue;
    const double length = (2.0 / rate + 2.0 * off * nearest) / (2.0 * std::numbers::pi);
    least = std::min(
        least, -kappa * nearest - beta * log_nearest - x.gamma * std::log(delta / 10.0) + std::log(length));
  }
  return least;
}

// The sum over the nodes, with the cuts of (1 - z s^-alpha)^-gamma inward, from each s* to 0, or outward:
//   F = (-z)^-gamma s^(alpha gamma - beta) (1 - s^alpha / z)^-gamma.
QuickValue power_sum(const PrabhakarParameters& x, const QuickArguments& argument,
                     const ShiftedContour& contour, bool outward) {
  const DoubleDouble minus_beta{-x.beta.hi, -x.beta.lo};
  const DoubleDouble exponent = outward ? exact_product(x.alpha, x.gamma) + minus_beta : minus_beta;
  const QuotientSum sum = sum_over_nodes(
      contour.nodes,
      BinomialPower{x.alpha, exponent, x.gamma, argument.scaled.log, argument.real(), outward});
  const Value value = to_long(sum.value);
  const QuickValue known{value, sum.error + few_ulps * norm1(value)};
  if (!outward) return known;
  const Value log = to_long(argument.scaled.log) - Value(0.0L, pi<long double>());  // of -z, for Im z >= 0
  const long double gamma = x.gamma;
  return with_factor(known,
                     argument.z.real() < 0.0 && argument.real() ? Value(std::exp(-gamma * log.real()))
                                                                : std::exp(-gamma * log),
                     few_ulps * (1.0L + std::abs(gamma) * (1.0L + norm1(log))));
}

// The error bound for F on a contour and the direction of the cuts; nullopt where the contour is not
// suitable.
struct ContourChoice {
  double log_bound;
  bool outward;
};
std::optional<ContourChoice> contour_choice(const PrabhakarParameters& x, const QuickArguments& argument,
                                            const SingularityRoots& roots, const ShiftedContour& contour) {
  const SingularityFreeStrip::Factor factor = roots.factor(x.gamma);
  const auto strip = contour.strip.bound_for(
      {.exponent = x.alpha * x.gamma - x.beta.hi, .alpha = x.alpha, .factors = {&factor, 1}});
  if (!strip || (strip->inside && strip->outside && !is_integer(x.gamma))) return std::nullopt;
  double sum = std::exp(strip->log_bound);
  for (std::size_t i = 0; i < roots.roots.size() && strip->outside; ++i) {
    const bool beyond = roots.roots[i].real() > 0.0 && contour.strip.position_of(roots.roots[i]) > 1.0;
    const double pair = argument.real() ? 2.0 : 1.0;
    if (beyond) sum += pair * std::exp(log_neglected_singularity(x, roots.poles.on_near_sheets[i].log));
  }
  return ContourChoice{std::log(sum), strip->outside};
}

}  // namespace

std::optional<QuickValue> prabhakar_on_contour(double alpha, const DoubleDouble& beta, double gamma,
                                               std::complex<double> z) {
  constexpr double most_parameter = 40.0, most_log = 250.0;
  const auto is_moderate = [](double parameter) { return std::abs(parameter) <= most_parameter; };
  if (!(gamma > 0.0) || !is_moderate(gamma) || !is_moderate(beta.hi) || z == 0.0) return std::nullopt;
  const QuickArguments argument(alpha, beta, z);
  if (std::abs(argument.log_size()) > most_log) return std::nullopt;
  const PrabhakarParameters x{alpha, beta, gamma};
  const auto& log = argument.scaled.log;
  const SingularityRoots roots(alpha, {log.re.hi, log.im.hi}, argument.real() ? 0 : -max_sheet);
  for (const ShiftedContour& contour : shifted_contours()) {
    const auto place = contour_choice(x, argument, roots, contour);
    if (!place || place->log_bound > max_log_error + roots.growth()) continue;
    QuickValue value = power_sum(x, argument, contour, place->outward);
    value.error += std::exp(place->log_bound);
    if (meets_tolerance(value)) return value;
  }
  return std::nullopt;
}

std::optional<QuickValue> prabhakar_series_quick(double alpha, const DoubleDouble& beta, double gamma,
                                                 std::complex<double> z) {
  constexpr int most_terms = 60;
  constexpr long double ulps = 4.0L * std::numeric_limits<long double>::epsilon();
  const long double modulus = std::abs(Value(z));
  QuickValue sum{0.0L, 0.0L};
  Value factor = 1.0L;  // (gamma)_j z^j / j!
  for (int j = 0; j < most_terms; ++j) {
    const DoubleDouble argument = beta + exact_product(j, alpha);
    const Value term = factor * reciprocal_gamma_of(argument);
    // Condition number of Gamma for large arguments.
    const long double size = 1.0L + std::abs(to_long(argument)), condition = size * (2.0L + std::ilogb(size));
    sum = sum + QuickValue{term, (few_ulps + (static_cast<long double>(j) + condition) * ulps) * norm1(term)};
    factor *= Value(z) * ((static_cast<long double>(gamma) + j) / (j + 1.0L));
    if (norm1(factor) > ulps * norm1(sum.value)) continue;
    const auto rest =
        tail(alpha, to_long(beta + exact_product(j + 1, alpha)), gamma, j + 1, norm1(factor), modulus);
    if (!rest || *rest > ulps * norm1(sum.value)) continue;
    sum.error += *rest;
    return meets_tolerance(sum) ? std::optional(sum) : std::nullopt;
  }
  return std::nullopt;
}

std::optional<QuickValue> derivative_by_recurrence(int k, double alpha, const DoubleDouble& beta,
                                                   std::complex<double> z) {
  if (k > max_quick_derivative || z == 0.0) return std::nullopt;
  const auto value = by_recurrence(k, alpha, beta, z);
  return value && meets_tolerance(*value) ? value : std::nullopt;
}

std::optional<QuickValue> prabhakar_quick(double alpha, const DoubleDouble& beta, double gamma,
                                          std::complex<double> z) {
  const bool first = gamma <= 0.0 || std::abs(z) < series_radius;
  if (first) {
    if (const auto series = prabhakar_series_quick(alpha, beta, gamma, z)) return series;
  }
  if (const auto on_contour = prabhakar_on_contour(alpha, beta, gamma, z)) return on_contour;
  if (gamma >= 1.0 && gamma <= max_quick_derivative + 1.0 && is_integer(gamma)) {
    const auto recurred = derivative_by_recurrence(static_cast<int>(gamma) - 1, alpha,
                                                   beta + exact_product(1.0 - gamma, alpha), z);
    if (recurred) return recurred;
  }
  return first ? std::nullopt : prabhakar_series_quick(alpha, beta, gamma, z);
}

}  // namespace fde::reference
