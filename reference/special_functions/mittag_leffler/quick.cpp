// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/mittag_leffler/quick.hpp"

#include <algorithm>
#include <cmath>

#include "fdebench/reference/special_functions/mittag_leffler/forms.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/quick_contours.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/tiny_order.hpp"

namespace fde::reference {
namespace {

using Value = std::complex<long double>;

// The first `count` terms of the asymptotic expansion (forms.hpp).
QuickValue leading_terms(const QuickArguments& x, int count) {
  const Value inverse = 1.0L / Value(x.z);
  QuickValue sum{0.0L, 0.0L};
  Value power = 1.0L;
  for (int k = 1; k <= count; ++k) {
    power *= inverse;
    const DoubleDouble argument = x.beta + exact_product(-k, x.alpha);
    const Value term = -power * reciprocal_gamma_of(argument);
    sum = sum + QuickValue{term, few_ulps * norm1(term)};
  }
  return sum;
}

QuickValue contour_sum(const QuickArguments& x, const QuickContour& contour, const DoubleDouble& exponent,
                       int peeled) {
  const double scale = std::scalbn(1.0, -std::max(x.scaled.exponent, 0));
  const std::complex<double> scaled = scale == 1.0 ? x.z : x.scaled.value;
  const QuotientSum sum = sum_over_nodes(contour.nodes, {x.alpha, exponent, scaled, scale});
  Value factor = scale;
  for (int k = 0; k < peeled; ++k) factor /= Value(x.z);
  const Value value = factor * to_long(sum.value);
  return {value, few_ulps * norm1(value) + norm1(factor) * sum.error};
}

DoubleDouble exponent_after(const QuickArguments& x, int peeled) {
  return exact_product(peeled + 1, x.alpha) + DoubleDouble{-x.beta.hi, -x.beta.lo};
}

// 1 + i theta = sqrt(s* / mu) for the point theta of each pole on a contour.
PerSheet<std::complex<double>> roots_on(const QuickArguments& x, double mu) {
  PerSheet<std::complex<double>> roots;
  const double modulus = std::exp(0.5 * (x.log_size() / x.alpha - std::log(mu)));
  for (const auto& pole : x.poles.on_near_sheets) roots.push_back(std::polar(modulus, 0.5 * pole.log.imag()));
  return roots;
}

// The peeled terms, the contour sum of the remainder, and the residues with their factors.
std::optional<QuickValue> on_contour(const QuickArguments& x, const QuickContours& contours, int peeled) {
  const DoubleDouble exponent = exponent_after(x, peeled);
  const auto roots = roots_on(x, contours.staggered.front().shape.mu);
  const QuickContour& contour = contours.away_from({roots.data(), roots.size()});
  const auto [log_bound, distance] =
      contour.bound.bound_for({.exponent = exponent.hi,
                               .alpha = x.alpha,
                               .log_size = x.log_size(),
                               .nearest_other_argument = x.poles.nearest_other_argument,
                               .roots = {roots.data(), roots.size()}});
  PerSheet<Pole<double>> counted;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    if (ContourBound::includes_residue(roots[i], distance)) counted.push_back(x.poles.on_near_sheets[i]);
  }
  const auto residues = residue_sum(x, &contour, counted);
  if (!residues) return std::nullopt;
  QuickValue sum = leading_terms(x, peeled) + contour_sum(x, contour, exponent, peeled) + *residues;
  sum.error += peeled == 0 ? std::exp(log_bound)
                           : std::exp(static_cast<long double>(log_bound) - peeled * x.log_size());
  return sum;
}

bool meets_tolerance(const QuickValue& value) {
  return value.error <= quick_tolerance * std::abs(value.value);
}

// The first terms of the power series next to beta = 0 and z = 0, where the terms on a contour cancel. As
// |1/Gamma(x)| <= 1.13 |x| for x >= -2^-30, the remainder is at most 1.2 |z|^m (alpha (m+1) + |beta|).
std::optional<QuickValue> first_terms(const QuickArguments& x) {
  constexpr long double near = 0x1p-30L;
  constexpr int count = 3;
  const Value z(x.z);
  const double beta = std::abs(x.beta.hi);
  if (beta > near || norm1(z) > near) return std::nullopt;
  QuickValue sum{0.0L, 0.0L};
  Value power = 1.0L;
  for (int k = 0; k < count; ++k) {
    const Value term = power * reciprocal_gamma_of(x.beta + exact_product(k, x.alpha));
    sum = sum + QuickValue{term, few_ulps * norm1(term)};
    power *= z;
  }
  sum.error += 1.2L * norm1(power) * ((count + 1) * static_cast<long double>(x.alpha) + beta);
  return meets_tolerance(sum) ? std::optional(sum) : std::nullopt;
}

// Tries the contours in turn, without and with peeled terms, until the bound is small enough; otherwise
// returns the value with the smallest bound.
std::optional<QuickValue> on_contours(const QuickArguments& x) {
  constexpr int moderate = 4, large = 16;  // log2 |z| from which peeling may help, and is needed
  std::optional<QuickValue> best;
  const auto try_with = [&](const QuickContours& contours, int peeled) {
    const auto value = on_contour(x, contours, peeled);
    if (value && (!best || value->error < best->error)) best = value;
    return best && meets_tolerance(*best);
  };
  for (const QuickContours& contours : quick_contours()) {
    for (const int peeled : {0, 2}) {
      if (peeled == 0 ? x.scaled.exponent >= large : x.scaled.exponent < moderate) continue;
      const double exponent = exponent_after(x, peeled).hi;
      if (contours.covers(exponent - x.alpha, exponent) && try_with(contours, peeled)) return best;
    }
  }
  return best;
}

QuickValue at_zero(const DoubleDouble& beta) {
  const long double value = is_pole_of_gamma(beta) ? 0.0L : reciprocal_gamma_of(beta);
  return {value, few_ulps * std::abs(value)};
}

QuickValue times(const QuickValue& x, const Value& factor) {
  const Value value = x.value * factor;
  return {value, norm1(factor) * x.error + few_ulps * norm1(value)};
}

}  // namespace

long double reciprocal_gamma_of(const DoubleDouble& x) {
  const long double value = static_cast<long double>(x.hi) + x.lo;
  if (value > 0.5L) return 1.0L / std::tgamma(value);
  const double whole = std::round(x.hi);
  const long double beyond = static_cast<long double>(x.hi - whole) + x.lo;
  const long double sign = std::fmod(whole, 2.0) == 0.0 ? 1.0L : -1.0L;
  return sign * std::sin(pi<long double>() * beyond) * std::tgamma(1.0L - value) / pi<long double>();
}

std::optional<QuickValue> mittag_leffler_quick(double alpha, const DoubleDouble& beta,
                                               std::complex<double> z) {
  if (const auto value = mittag_leffler_tiny_order(alpha, beta, z)) return value;
  switch (evaluation_form(alpha, beta, z)) {
    case EvaluationForm::at_zero:
      return at_zero(beta);
    case EvaluationForm::residues_only:
      return sum_of_all_residues({alpha, beta, z});
    case EvaluationForm::shifted_beta: {
      const auto shifted = mittag_leffler_quick(alpha, beta + DoubleDouble{alpha, 0.0}, z);
      return shifted ? std::optional(times(*shifted, z)) : std::nullopt;
    }
    case EvaluationForm::on_contour:
      break;
  }
  const QuickArguments x(alpha, beta, z);
  const auto near = first_terms(x);
  return near ? near : on_contours(x);
}

}  // namespace fde::reference
