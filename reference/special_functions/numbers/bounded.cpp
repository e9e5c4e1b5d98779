// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/numbers/bounded.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace fde::reference {

namespace {

std::string scientific(const BigReal& x, int digits) { return to_text(x, "%.*Re", digits - 1); }

// x to `digits` significant digits, with an exponent only below 1e-5 and from 10^digits on.
std::string in_decimal(const BigReal& x, int digits) {
  constexpr int most_zeros = 5;
  const std::string text = scientific(x, digits);
  const auto exponent = std::stoll(text.substr(text.find('e') + 1));
  return exponent < -most_zeros || exponent >= digits
             ? text
             : to_text(x, "%.*Rf", digits - 1 - static_cast<int>(exponent));
}

// The next double: an upper bound again, for a bound that was rounded to nearest.
double round_up(double bound) { return std::nextafter(bound, std::numeric_limits<double>::infinity()); }

// Number of decimal digits by which the bound exceeds the target; 0 where the target is met.
int missing_digits(const WorkingEstimate& estimate, const DigitSearchOptions& search, int digits) {
  if (estimate.is_final) return 0;
  const auto& [value, bound] = estimate.value_and_bound;
  if (!isfinite(bound)) return digits;  // a divisor was computed as 0
  if (bound == 0) return 0;
  const BigReal zero = estimate.scale * pow(BigReal(10), -search.zero_digits);
  const BigReal size = std::max(norm1(value), zero);
  if (size == 0 || !isfinite(size)) return digits;
  const BigReal missing = ceil(log10(BigReal(bound / size))) + search.target_digits;
  return static_cast<int>(std::clamp(missing, BigReal(0), BigReal(max_working_digits(search.target_digits))));
}

}  // namespace

std::string to_bound_text(const BigReal& bound) {
  if (!isfinite(bound)) return "inf";
  return bound == 0 ? "0"
                    : scientific(BigReal(bound * 1.06), 2);  // so that two digits are never below the bound
}

DecimalText to_decimal_text(const BigReal& value, const BigReal& bound, int digits) {
  if (!isfinite(value)) return {to_text(value, digits), BigReal(std::numeric_limits<double>::infinity())};
  if (abs(value) <= bound) return {"0", BigReal(abs(value) + bound)};
  const auto supported = bound == 0 ? BigReal(digits) : BigReal(1 + log10(BigReal(abs(value) / bound)));
  const std::string text = in_decimal(value, supported < digits ? static_cast<int>(supported) : digits);
  return {text, BigReal(abs(BigReal(parse<BigReal>(text) - value)) + bound)};
}

BoundedDouble to_double(const Complex<long double>& value, long double error) {
  const std::complex<double> rounded(static_cast<double>(value.real()), static_cast<double>(value.imag()));
  if (!std::isfinite(rounded.real()) || !std::isfinite(rounded.imag()))
    return {rounded, std::numeric_limits<double>::infinity()};
  const Complex<long double> off(value.real() - rounded.real(), value.imag() - rounded.imag());
  return {rounded, round_up(static_cast<double>(norm1(off) + error))};
}

BoundedDouble to_double(const Bounded<BigReal>& x) {
  const auto re = real_part<BigReal>(x.value), im = imag_part<BigReal>(x.value);
  const bool nothing = norm1(x.value) <= x.bound;
  std::complex<double> rounded = 0.0;
  if (!nothing) rounded = {re.convert_to<double>(), im.convert_to<double>()};
  if (!std::isfinite(rounded.real()) || !std::isfinite(rounded.imag()))
    return {rounded, std::numeric_limits<double>::infinity()};
  const BigReal off = abs(BigReal(re - rounded.real())) + abs(BigReal(im - rounded.imag()));
  return {rounded, round_up(BigReal(off + x.bound).convert_to<double>())};
}

DigitSearchResult increase_digits(const DigitSearchOptions& search,
                                  const std::function<std::vector<WorkingEstimate>(int digits)>& evaluate) {
  const int most = max_working_digits(search.target_digits);
  for (int digits = search.target_digits + search.guard;;) {
    DigitSearchResult raised{.values = {}, .digits = digits};
    int missing = 0;
    for (auto& estimate : evaluate(digits)) {
      const int own = missing_digits(estimate, search, digits);
      missing = std::max(missing, own);
      const BigReal& bound = estimate.value_and_bound.bound;
      if (own > 0 && !(raised.largest_missed_bound && bound < *raised.largest_missed_bound))
        raised.largest_missed_bound = bound;
      raised.values.push_back(std::move(estimate.value_and_bound));
    }
    if (missing == 0 || digits >= most) return raised;
    digits = std::min(search.next_digits(digits, missing), most);
  }
}

std::runtime_error insufficient_digits(const DigitSearchResult& raised) {
  return std::runtime_error(fmt::format("no accurate value in reach: bound {} at {} digits",
                                        to_bound_text(raised.largest_missed_bound.value()), raised.digits));
}

}  // namespace fde::reference
