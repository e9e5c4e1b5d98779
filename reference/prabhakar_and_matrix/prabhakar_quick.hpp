#pragma once

#include "mittag_leffler/quick.hpp"

// Prabhakar's function in long double and double-double, for Im z >= 0. Empty where its error is above
// quick_tolerance of the value.
namespace fde {

// sum_j (gamma)_j z^j / (j! Gamma(alpha j + beta)) by its terms, while they fall fast enough.
std::optional<QuickValue> prabhakar_series_quick(double alpha, const DoubleDouble& beta, double gamma,
                                                 std::complex<double> z);

// The k-th derivative of E_{alpha,beta} in z over k!, E^(k+1)_{alpha,beta+k alpha}(z), for k up to
// most_quick_derivative from
//   alpha z E'_{alpha,beta} = E_{alpha,beta-1} - (beta - 1) E_{alpha,beta},
// k times, which loses about |z|^k. beta may be off by the rounding of a double-double: that shows in the
// value for |z| far below series_radius only, where the loss has made it useless.
inline constexpr int most_quick_derivative = 8;
std::optional<QuickValue> derivative_by_recurrence(int k, double alpha, const DoubleDouble& beta,
                                                   std::complex<double> z);

// For gamma > 0 on a contour that has each singularity of
//   F(s) = s^(alpha gamma - beta) / (s^alpha - z)^gamma = s^-beta (1 - z s^-alpha)^-gamma
// on its left, or so far beyond it in the left half-plane that it contributes nothing.
std::optional<QuickValue> prabhakar_on_contour(double alpha, const DoubleDouble& beta, double gamma,
                                               std::complex<double> z);

// The quickest of these that does: below this |z| the series is tried first.
inline constexpr double series_radius = 0.4;
std::optional<QuickValue> prabhakar_quick(double alpha, const DoubleDouble& beta, double gamma,
                                          std::complex<double> z);

}  // namespace fde
