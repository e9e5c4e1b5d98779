// SPDX-License-Identifier: MIT
#pragma once

#include <complex>

namespace fde::reference {

// Whether |E_{alpha,beta}(z)|, Im z >= 0, is certainly below half the smallest positive double, as
// 1/Gamma(beta) is for a large beta.
bool certainly_underflows(double alpha, double beta, std::complex<double> z);

}  // namespace fde::reference
