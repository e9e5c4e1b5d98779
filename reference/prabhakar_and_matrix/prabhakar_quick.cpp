#include "prabhakar_and_matrix/prabhakar_quick.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fde {
namespace {

using Value = std::complex<long double>;

long double to_long(const DoubleDouble& x) { return static_cast<long double>(x.hi) + x.lo; }

bool is_good(const QuickValue& x) { return x.error <= quick_tolerance * std::abs(x.value); }

// As in prabhakar_series.cpp: a bound of the terms from `next` on, whose factor beside 1/Gamma has that size.
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
  return {value, size_of(factor) * x.error + (relative_error + few_ulps) * size_of(value)};
}

// The coefficients of E_{alpha,beta-j} in z^k d^k/dz^k E_{alpha,beta} = theta (theta - 1) ... (theta - k + 1)
// E, theta = z d/dz; and of what rounding may add up to.
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
                                                               few_ulps * sizes[j] * size_of(value->value)};
  }
  Value factor = 1.0L;
  for (int m = 1; m <= k; ++m) factor /= static_cast<long double>(m) * Value(z);
  return with_factor(sum, factor, 4.0L * static_cast<long double>(k) * few_ulps);
}

}  // namespace

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
    // Gamma of a large argument turns its rounding into as many more ulps.
    const long double size = 1.0L + std::abs(to_long(argument)), condition = size * (2.0L + std::ilogb(size));
    sum =
        sum + QuickValue{term, (few_ulps + (static_cast<long double>(j) + condition) * ulps) * size_of(term)};
    factor *= Value(z) * ((static_cast<long double>(gamma) + j) / (j + 1.0L));
    if (size_of(factor) > ulps * size_of(sum.value)) continue;
    const auto rest =
        tail(alpha, to_long(beta + exact_product(j + 1, alpha)), gamma, j + 1, size_of(factor), modulus);
    if (!rest || *rest > ulps * size_of(sum.value)) continue;
    sum.error += *rest;
    return is_good(sum) ? std::optional(sum) : std::nullopt;
  }
  return std::nullopt;
}

std::optional<QuickValue> derivative_by_recurrence(int k, double alpha, const DoubleDouble& beta,
                                                   std::complex<double> z) {
  if (k > most_quick_derivative || z == 0.0) return std::nullopt;
  const auto value = by_recurrence(k, alpha, beta, z);
  return value && is_good(*value) ? value : std::nullopt;
}

std::optional<QuickValue> derivative_quick(int k, double alpha, double beta, std::complex<double> z) {
  const DoubleDouble exact{beta, 0.0};
  if (std::abs(z) < series_radius && k <= most_quick_derivative) {
    const auto series = prabhakar_series_quick(alpha, exact + exact_product(k, alpha), k + 1.0, z);
    if (series) return series;
  }
  return derivative_by_recurrence(k, alpha, exact, z);
}

}  // namespace fde
