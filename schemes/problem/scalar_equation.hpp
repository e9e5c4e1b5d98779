// SPDX-License-Identifier: MIT
#pragma once

#include <complex>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// The test equation D^order y = rate y, y(0) = 1, y'(0) = 0. A real rate gives one component; a complex rate
// gives two, real and imaginary part, whose matrix has the eigenvalues rate and its conjugate.
Problem scalar_equation(double order, std::complex<double> rate, double end = 1.0);

// D^order y = rate y + delayed_rate y(t - lag), y = 1 up to t = 0 and y'(0) = 0.
Problem delayed_equation(double order, double rate, double delayed_rate, double lag, double end = 1.0);

// The test equation in multi-term form, as chains without terms.
Problem scalar_multi_term_equation(double order, std::complex<double> rate, double end = 1.0);

}  // namespace fde
