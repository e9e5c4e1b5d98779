// SPDX-License-Identifier: MIT
#pragma once

#include <complex>

namespace fde {

using ComplexValue = std::complex<double>;

// exp(z) - 1 without cancellation.
ComplexValue exp_minus_one(ComplexValue z);

// (-mu)^(1-s) Li_s(e^mu) with the polylogarithm Li_s(zeta) = sum_{k>=1} zeta^k / k^s; finite at mu = 0.
// Preconditions: s <= 0, -0.7 <= Re mu <= 0, |Im mu| <= pi. Relative error about 1e-14, except near zeros of
// Li_s.
ComplexValue scaled_polylogarithm(double s, ComplexValue mu);

}  // namespace fde
