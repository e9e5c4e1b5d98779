#pragma once

#include <complex>
#include <optional>
#include <string>

#include "mittag_leffler/mittag_leffler.hpp"
#include "numbers/bounded.hpp"

// What the Mittag-Leffler functions share: their arguments checked and read, their values written.
namespace fde {

// The number that a decimal text names, rounded once. Throws std::invalid_argument "function: name: ..."
// where it names no finite number.
BigReal read_argument(const std::string& function, const std::string& name, const std::string& text);
// z from its two parts.
BigComplex read_complex(const std::string& function, const std::string& re, const std::string& im);

// The double that a decimal text names exactly: of "0.5", not of "0.1", which lies between two. Nothing where
// there is none, or the text is no number.
std::optional<double> exact_double(const std::string& text);

// Throw std::invalid_argument naming the function, the argument and its value: alpha outside (0, 5], beta (or
// another parameter) outside [-10000, 10000], z not finite, digits below 1.
void require_order(const std::string& function, double alpha);
void require_order(const std::string& function, const BigReal& alpha);
void require_parameter(const std::string& function, const char* argument, double value);
void require_parameter(const std::string& function, const char* argument, const BigReal& value);
void require_finite(const std::string& function, std::complex<double> z);
void require_digits(const std::string& function, int digits);

// Of a decimal text after its point: "1.25e-3" has 5. Of doubles, as many as make both and their sums exact.
int decimal_places(const std::string& text);
int decimal_places(double a, double b);

// In decimal, with the rounding of the texts in the bound. Of a real function the imaginary part is "0".
DecimalComplex write_complex(const Bounded<BigReal>& x, bool real, int digits);

// The nearest double to what is written, with that rounding in the bound.
MittagLefflerValue rounded_to_double(const DecimalComplex& written);

}  // namespace fde
