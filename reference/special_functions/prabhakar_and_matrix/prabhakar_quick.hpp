// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/special_functions/mittag_leffler/quick.hpp"

// Prabhakar's function in long double and double-double, for Im z >= 0. nullopt where the error is above
// quick_tolerance of the value.
namespace fde::reference {

// By the series sum_j (gamma)_j z^j / (j! Gamma(alpha j + beta)), if its terms decay fast enough.
std::optional<QuickValue> prabhakar_series_quick(double alpha, const DoubleDouble& beta, double gamma,
                                                 std::complex<double> z);

// The k-th derivative of E_{alpha,beta} at z divided by k!, E^(k+1)_{alpha,beta+k alpha}(z), for
// k <= max_quick_derivative, by k applications of
//   alpha z E'_{alpha,beta} = E_{alpha,beta-1} - (beta - 1) E_{alpha,beta},
// which lose about a factor |z|^k of accuracy. beta may have the rounding error of a double-double: it
// matters only for |z| far below series_radius, where this loss makes the value useless anyway.
inline constexpr int max_quick_derivative = 8;
std::optional<QuickValue> derivative_by_recurrence(int k, double alpha, const DoubleDouble& beta,
                                                   std::complex<double> z);

// For gamma > 0 on a contour that has each singularity of
//   F(s) = s^(alpha gamma - beta) / (s^alpha - z)^gamma = s^-beta (1 - z s^-alpha)^-gamma
// on its left, or outside it so far in the left half-plane that its contribution is negligible.
std::optional<QuickValue> prabhakar_on_contour(double alpha, const DoubleDouble& beta, double gamma,
                                               std::complex<double> z);

// The first of these methods that is accurate enough; for |z| < series_radius the series is tried first.
inline constexpr double series_radius = 0.4;
std::optional<QuickValue> prabhakar_quick(double alpha, const DoubleDouble& beta, double gamma,
                                          std::complex<double> z);

}  // namespace fde::reference
