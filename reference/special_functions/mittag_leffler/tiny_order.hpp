// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <optional>

#include "fdebench/reference/special_functions/mittag_leffler/quick.hpp"
#include "fdebench/reference/special_functions/numbers/bounded.hpp"

// E_{alpha,beta}(z) for Im z >= 0 and an order so small that s^alpha is nearly 1 on the relevant part of a
// contour: the contour integral cancels to the size of alpha, |1-z| or 1/Gamma(beta), and takes hundreds of
// digits. nullopt where the order is not small compared with |1-z|, where e^s* of a pole s*^alpha = z is not
// negligible, and where the error is above quick_tolerance.
namespace fde::reference {

// For |beta| <= 1600, otherwise nullopt.
std::optional<QuickValue> mittag_leffler_tiny_order(double alpha, const DoubleDouble& beta,
                                                    std::complex<double> z);

// For |beta| > 1600, otherwise nullopt. The value underflows to 0 (beta > 0), or its nonzero parts overflow
// to infinity.
std::optional<BoundedDouble> mittag_leffler_tiny_order_out_of_range(double alpha, double beta,
                                                                    std::complex<double> z);

}  // namespace fde::reference
