// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <optional>
#include <string>

#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "fdebench/reference/special_functions/numbers/bounded.hpp"

// Parsing and checks of arguments and output of values, shared by the Mittag-Leffler functions.
namespace fde::reference {

// The decimal number in text, rounded once. Throws std::invalid_argument "function: name: ..." unless text is
// a finite number.
BigReal parse_argument(const std::string& function, const std::string& name, const std::string& text);
// z = re + i im; throws as parse_argument() does.
BigComplex parse_complex(const std::string& function, const std::string& re, const std::string& im);

// The double equal to the decimal number in text: 0.5 for "0.5". nullopt where no double is equal to it, as
// for "0.1", or text is no number.
std::optional<double> exact_double(const std::string& text);

// Throw std::invalid_argument naming the function, the argument and its value if alpha is outside (0, 5],
// beta (or another parameter) outside [-10000, 10000], z not finite, or digits < 1.
void require_order(const std::string& function, double alpha);
void require_order(const std::string& function, const BigReal& alpha);
void require_parameter(const std::string& function, const char* argument, double value);
void require_parameter(const std::string& function, const char* argument, const BigReal& value);
void require_finite(const std::string& function, std::complex<double> z);
void require_digits(const std::string& function, int digits);

// Number of digits after the decimal point: 5 for "1.25e-3". For doubles, the additional working digits that
// hold a, b and their sums exactly.
int decimal_places(const std::string& text);
int decimal_places(double a, double b);

// x as decimal text; the bound includes the rounding of the texts. If real, the imaginary part is "0".
DecimalComplex to_decimal_complex(const Bounded<BigReal>& x, bool real, int digits);

// The nearest double, with that rounding in the bound; infinite if written.bound is "inf".
MittagLefflerValue rounded_to_double(const DecimalComplex& written);

}  // namespace fde::reference
