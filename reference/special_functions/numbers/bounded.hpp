// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::reference {

// A value and a bound of the modulus of its error.
template <class Real>
struct Bounded {
  Complex<Real> value;
  Real bound;
};

// A real number as decimal text, with as many significant digits as its bound supports but at most `digits`.
// The bound includes the rounding of the text. A value not larger than its bound is written as 0.
struct DecimalText {
  std::string value;
  BigReal bound;
};
DecimalText to_decimal_text(const BigReal& value, const BigReal& bound, int digits);
std::string to_bound_text(const BigReal& bound);  // two digits, rounded up

// The nearest double and a bound that includes the rounding to it; the bound is infinite where the value
// overflows. A multiprecision value not larger than its bound becomes 0.
struct BoundedDouble {
  std::complex<double> value;
  double bound;
};
BoundedDouble to_double(const Complex<long double>& value, long double error);
BoundedDouble to_double(const Bounded<BigReal>& x);

// Decimal digits of a value that rounds almost correctly to double.
inline constexpr int double_digits = 17;
// Largest relative error of an evaluation in long double whose result is accepted and rounded to double.
inline constexpr long double double_tolerance = 5e-16L;

// Result of an evaluation with a certain number of working digits.
struct WorkingEstimate {
  Bounded<BigReal> value_and_bound;
  BigReal scale = BigReal(0);  // size of the summands of the value; 0: the value never counts as zero
  bool is_final = false;       // more digits change nothing: the value is infinite, or structurally 0
};

// Parameters of increase_digits().
struct DigitSearchOptions {
  int target_digits;  // decimal digits of relative accuracy
  int guard;          // working digits beyond those in the first evaluation
  // The working digits of the next evaluation, after one with `digits` that lacked `missing` digits.
  std::function<int(int digits, int missing)> next_digits;
  int zero_digits = 40;  // a value this many digits below its scale counts as zero
};

// The values of the last evaluation, and its working digits.
struct DigitSearchResult {
  std::vector<Bounded<BigReal>> values;
  int digits;
  std::optional<BigReal> largest_missed_bound{};  // the largest bound that misses the target, if one does
};

// Largest number of working digits.
constexpr int max_working_digits(int wanted) { return 4 * wanted + 1000; }

// Raises the working digits until every bound is at most 10^-target_digits max(|value|, 10^-zero_digits
// scale), or until there are max_working_digits(target_digits). Precondition: a Precision is in force;
// evaluate() sets its own.
DigitSearchResult increase_digits(const DigitSearchOptions& search,
                                  const std::function<std::vector<WorkingEstimate>(int digits)>& evaluate);

// The exception to throw if raised.largest_missed_bound has a value: "no accurate value in reach: bound ...
// at ... digits".
std::runtime_error insufficient_digits(const DigitSearchResult& raised);

}  // namespace fde::reference
