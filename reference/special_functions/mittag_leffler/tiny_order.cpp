// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/mittag_leffler/tiny_order.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fde::reference {
namespace {

using Value = std::complex<long double>;

constexpr double most_beta = 1600.0;  // up to which Gamma and its products do not overflow in long double

// 1/Gamma(beta) and its derivative, both divided by a positive scale: Gamma(1-beta) for beta <= 1/2,
// 1/Gamma(beta) above. At the distance epsilon <= 1/2 from a zero -n of 1/Gamma they are
//   (-1)^n epsilon + beyond,   (-1)^n + slope_beyond.
class ReciprocalGamma {
 public:
  explicit ReciprocalGamma(const DoubleDouble& beta);

  [[nodiscard]] long double value() const { return sign_ * epsilon_ + beyond_; }
  [[nodiscard]] long double slope() const { return sign_ + slope_beyond_; }
  [[nodiscard]] long double slope_error() const { return slope_error_; }
  // value - alpha slope; epsilon - alpha first, as the two may cancel.
  [[nodiscard]] long double value_minus_slope(long double alpha) const {
    return sign_ * (epsilon_ - alpha) + (beyond_ - alpha * slope_beyond_);
  }

 private:
  long double epsilon_ = 0.0L, sign_ = 0.0L, beyond_ = 1.0L, slope_beyond_ = 0.0L, slope_error_ = 0.0L;
};

// By the reflection formula, with log x - 1/x < psi(x) < log x - 1/(2x).
ReciprocalGamma::ReciprocalGamma(const DoubleDouble& beta) {
  constexpr long double half = 0.5L, near = 1e-5L;
  const long double number = static_cast<long double>(beta.hi) + beta.lo;
  const long double x = number <= half ? 1.0L - number : number;
  if (number <= half) {
    const double whole = std::round(beta.hi);
    epsilon_ = static_cast<long double>(beta.hi - whole) + beta.lo;
    sign_ = std::fmod(whole, 2.0) == 0.0 ? 1.0L : -1.0L;
    const long double angle = pi<long double>() * epsilon_, sine = std::sin(angle / 2.0L);
    beyond_ = sign_ * (std::abs(epsilon_) < near ? -angle * angle * epsilon_ / 6.0L
                                                 : std::sin(angle) / pi<long double>() - epsilon_);
    slope_beyond_ = -2.0L * sign_ * sine * sine;  // cos(angle) - 1, with the sign
  }
  slope_beyond_ -= value() * (std::log(x) - 0.75L / x);
  slope_error_ = std::abs(value()) / (4.0L * x);
}

// An upper bound of (1/2 pi) int |e^s s^-beta log^2 s| |ds|, divided by the same scale, on Hankel's contour:
// a circle around 0 with radius r = max(1, beta), and both sides of the cut. The circle contributes
// e^r r^(1-beta) (log^2 r + pi^2), by Stirling's series at most
// 2.8 sqrt(beta) (log^2 beta + pi^2) / Gamma(beta) for beta >= 1. As log^2 t <= t, the cut contributes less,
// or at most Gamma(1-beta) (|beta| + 11) / pi.
long double moment(double beta) {
  constexpr long double pi_squared = 9.87L;
  if (beta <= 0.5) return 42.0L + std::abs(beta);
  const long double log = std::log(static_cast<long double>(beta));
  return 10.0L * std::sqrt(static_cast<long double>(beta)) * (log * log + pi_squared);
}

// Whether every s with alpha |log s| > |1-z| / 4 is negligible: e^s is negligible there, or the contour goes
// around it. False if there is a pole with |s*| > 1 in the right half plane.
bool is_small(long double alpha, const Value& z, long double distance) {
  constexpr long double small = 1e-14L,
                        right_angle = std::numbers::pi_v<long double> / 2.0L * (1.0L + 1e-15L);
  const bool grows = z.real() > 0.0L && std::abs(z) > 1.0L && z.imag() <= right_angle * alpha * z.real();
  return alpha <= small * std::min(1.0L, distance) && !grows;
}

// E divided by the scale. With x = alpha log s
//   s^alpha / (s^alpha - z) = 1/(1-z) - x z/(1-z)^2 + O(x^2),
//   E_{alpha,beta}(z) = 1/Gamma(beta) / (1-z) + alpha (1/Gamma)'(beta) z/(1-z)^2 + rest,
// where O(x^2) is at most 2.5 |x|^2 |z| (1+|z|) / |1-z|^3 for |x| <= min(1, |1-z|) / 4.
std::optional<QuickValue> over_scale(double order, const DoubleDouble& beta, std::complex<double> argument) {
  constexpr long double far = 2.0L;
  const Value z(argument), rest = 1.0L - z;
  const long double alpha = order, size = std::abs(z), distance = std::abs(rest);
  if (size == 0.0L || !is_small(alpha, z, distance)) return std::nullopt;
  const ReciprocalGamma gamma(beta);
  // By z/(1-z)^2 = 1/(1-z)^2 - 1/(1-z), terms that cancel for large z are combined.
  const Value first = (size > far ? gamma.value_minus_slope(alpha) : gamma.value()) / rest,
              second = alpha * gamma.slope() / rest * ((size > far ? Value(1.0L) : z) / rest);
  const long double linear = alpha / distance * (size / distance),
                    square = alpha / distance * linear * (1.0L + size);
  const QuickValue sum{first + second, few_ulps * (std::abs(first) + std::abs(second)) +
                                           3.0L * linear * gamma.slope_error() +
                                           2.5L * square * moment(beta.hi)};
  return sum.error <= quick_tolerance * std::abs(sum.value) ? std::optional(sum) : std::nullopt;
}

}  // namespace

std::optional<QuickValue> mittag_leffler_tiny_order(double alpha, const DoubleDouble& beta,
                                                    std::complex<double> z) {
  if (std::abs(beta.hi) > most_beta) return std::nullopt;
  const auto sum = over_scale(alpha, beta, z);
  if (!sum) return std::nullopt;
  const long double number = static_cast<long double>(beta.hi) + beta.lo;
  const long double scale = number <= 0.5L ? std::tgamma(1.0L - number) : 1.0L / std::tgamma(number);
  const Value value = scale * sum->value;
  return QuickValue{value, scale * sum->error + few_ulps * std::abs(value)};
}

// The scale is at least 1e4400 or at most 1e-4400: no double factor leads back into the range of double.
std::optional<BoundedDouble> mittag_leffler_tiny_order_out_of_range(double alpha, double beta,
                                                                    std::complex<double> z) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (std::abs(beta) <= most_beta) return std::nullopt;
  const auto sum = over_scale(alpha, {beta, 0.0}, z);
  if (!sum) return std::nullopt;
  if (beta > 0.0) return BoundedDouble{0.0, std::numeric_limits<double>::denorm_min()};
  const auto part = [](long double x) { return x == 0.0L ? 0.0 : std::signbit(x) ? -infinity : infinity; };
  return BoundedDouble{{part(sum->value.real()), part(sum->value.imag())}, infinity};
}

}  // namespace fde::reference
