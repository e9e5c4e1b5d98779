#pragma once

#include <complex>
#include <optional>

#include "mittag_leffler/quick.hpp"
#include "numbers/bounded.hpp"

// E_{alpha,beta}(z) for Im z >= 0 and an order so small that s^alpha is 1 wherever a contour counts: what is
// left on one is as small as alpha, |1-z| or 1/Gamma(beta), and takes hundreds of digits. Empty where the
// order is not that small beside |1-z|, where e^s* of a pole s*^alpha = z counts, and where the error is
// above quick_tolerance.
namespace fde {

// For |beta| up to 1600.
std::optional<QuickValue> of_tiny_order(double alpha, const DoubleDouble& beta, std::complex<double> z);

// For |beta| above, where 0 is the nearest double, or none is near: then the parts that overflow are
// infinite.
std::optional<DoubleBounded> beyond_double_of_tiny_order(double alpha, double beta, std::complex<double> z);

}  // namespace fde
