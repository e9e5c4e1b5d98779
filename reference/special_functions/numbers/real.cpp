// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/numbers/real.hpp"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>
#include <system_error>

namespace fde::reference {
namespace {

std::recursive_mutex& precision_mutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

void set_default_precision(unsigned digits) {
  BigReal::default_precision(digits);
  BigComplex::default_precision(digits);
}

[[noreturn]] void reject(const std::string& text) {
  throw std::invalid_argument(fmt::format("'{}' is not a finite decimal number", text));
}

}  // namespace

Precision::Precision(int digits) : lock_(precision_mutex()), before_(BigReal::default_precision()) {
  set_default_precision(static_cast<unsigned>(digits));
  mpfr_set_emax(mpfr_get_emax_max());  // the exponent range is per thread; by default e^(7e8) overflows
  mpfr_set_emin(mpfr_get_emin_min());
}

Precision::~Precision() { set_default_precision(before_); }

template <>
long double parse<long double>(const std::string& text) {
  long double value = 0.0L;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) reject(text);
  return value;
}

template <>
BigReal parse<BigReal>(const std::string& text) {
  BigReal value;
  if (mpfr_set_str(value.backend().data(), text.c_str(), 10, MPFR_RNDN) != 0 || !isfinite(value))
    reject(text);
  return value;
}

// Not Boost's conversion: it writes all digits where 0 digits after the point are requested.
std::string to_text(const BigReal& x, const char* format, int precision) {
  const int length = mpfr_snprintf(nullptr, 0, format, precision, x.backend().data());
  std::string text(static_cast<std::size_t>(length) + 1, '\0');  // with the terminating null
  mpfr_snprintf(text.data(), text.size(), format, precision, x.backend().data());
  text.pop_back();
  return text;
}

std::string to_text(const BigReal& x, int digits) { return to_text(x, "%.*Rg", digits); }

template <>
long double from_shortest_decimal<long double>(double x) {
  return parse<long double>(fmt::format("{}", x));
}

template <>
BigReal from_shortest_decimal<BigReal>(double x) {
  return parse<BigReal>(fmt::format("{}", x));
}

}  // namespace fde::reference
