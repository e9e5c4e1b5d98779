#pragma once

#include "mittag_leffler/quick.hpp"

// Prabhakar's function in long double, for Im z >= 0. Empty where its error is above quick_tolerance of the
// value.
namespace fde {

// sum_j (gamma)_j z^j / (j! Gamma(alpha j + beta)) by its terms, while they fall fast enough.
std::optional<QuickValue> prabhakar_series_quick(double alpha, const DoubleDouble& beta, double gamma,
                                                 std::complex<double> z);

// The k-th derivative of E_{alpha,beta} in z over k!, E^(k+1)_{alpha,beta+k alpha}(z): by those terms, or
// from
//   alpha z E'_{alpha,beta} = E_{alpha,beta-1} - (beta - 1) E_{alpha,beta},
// k times, which loses about |z|^k.
std::optional<QuickValue> derivative_quick(int k, double alpha, const DoubleDouble& beta,
                                           std::complex<double> z);

}  // namespace fde
