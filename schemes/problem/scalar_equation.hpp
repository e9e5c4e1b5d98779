#pragma once

#include <complex>

#include "problem/problem.hpp"

namespace fde {

// D^order y = rate y from y(0) = 1, y'(0) = 0, as a problem: of one component, or of real and imaginary part
// for a complex rate, whose modes then are those of the rate and of its conjugate.
Problem scalar_equation(double order, std::complex<double> rate, double end = 1.0);

// The same told as multi-term equations without terms.
Problem scalar_chain(double order, std::complex<double> rate, double end = 1.0);

}  // namespace fde
