// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/mittag_leffler/decimal_arguments.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "fdebench/reference/special_functions/numbers/bounded.hpp"

namespace fde::reference {
namespace {

template <class Number>
void check_order(const std::string& function, const Number& alpha) {
  if (alpha > 0 && alpha <= 5) return;
  throw std::invalid_argument(
      fmt::format("{}: alpha = {} has to be in (0, 5]", function, static_cast<double>(alpha)));
}

template <class Number>
void check_parameter(const std::string& function, const char* argument, const Number& value) {
  if (value >= -largest_parameter && value <= largest_parameter) return;
  throw std::invalid_argument(fmt::format("{}: {} = {} has to be in [-{}, {}]", function, argument,
                                          static_cast<double>(value), largest_parameter, largest_parameter));
}

}  // namespace

BigReal parse_argument(const std::string& function, const std::string& name, const std::string& text) {
  try {
    return parse<BigReal>(text);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}: {}", function, name, error.what()));
  }
}

BigComplex parse_complex(const std::string& function, const std::string& re, const std::string& im) {
  return {parse_argument(function, "re z", re), parse_argument(function, "im z", im)};
}

std::optional<double> exact_double(const std::string& text) {
  const Precision precision(std::numeric_limits<double>::max_digits10);
  BigReal value;
  char* end = nullptr;
  const int rounded = mpfr_strtofr(value.backend().data(), text.c_str(), &end, 10, MPFR_RNDN);
  if (rounded != 0 || text.empty() || *end != '\0' || !isfinite(value)) return std::nullopt;
  const auto number = value.convert_to<double>();
  return value == number ? std::optional(number) : std::nullopt;
}

void require_order(const std::string& function, double alpha) { check_order(function, alpha); }
void require_order(const std::string& function, const BigReal& alpha) { check_order(function, alpha); }

void require_parameter(const std::string& function, const char* argument, double value) {
  check_parameter(function, argument, value);
}
void require_parameter(const std::string& function, const char* argument, const BigReal& value) {
  check_parameter(function, argument, value);
}

void require_finite(const std::string& function, std::complex<double> z) {
  if (std::isfinite(z.real()) && std::isfinite(z.imag())) return;
  throw std::invalid_argument(
      fmt::format("{}: z = {} {:+} i has to be finite", function, z.real(), z.imag()));
}

void require_digits(const std::string& function, int digits) {
  if (digits >= 1 && digits <= max_digits) return;
  throw std::invalid_argument(
      fmt::format("{}: digits = {} has to be in [1, {}]", function, digits, max_digits));
}

int decimal_places(const std::string& text) {
  const auto e = std::min(text.find_first_of("eE"), text.size()), point = std::min(text.find('.'), e);
  const long written = e == point ? 0 : static_cast<long>(e - point) - 1;
  const long exponent = e == text.size() ? 0 : std::strtol(text.c_str() + e + 1, nullptr, 10);
  return static_cast<int>(std::clamp(written - exponent, 0L, 100000L));
}

int decimal_places(double a, double b) {
  constexpr int mantissa = std::numeric_limits<double>::digits;
  const auto lowest_bit = [](double x) { return x == 0.0 ? 0 : std::ilogb(x) - mantissa; };
  const int lowest = std::min(lowest_bit(a), lowest_bit(b));
  return static_cast<int>(std::ceil(std::max(0, -lowest) * std::numbers::ln2 / std::numbers::ln10));
}

DecimalComplex to_decimal_complex(const Bounded<BigReal>& x, bool real, int digits) {
  const DecimalText re = to_decimal_text(real_part<BigReal>(x.value), x.bound, digits);
  if (real) return {re.value, "0", to_bound_text(re.bound)};
  const DecimalText im = to_decimal_text(imag_part<BigReal>(x.value), x.bound, digits);
  return {re.value, im.value, to_bound_text(BigReal(re.bound + im.bound))};
}

MittagLefflerValue rounded_to_double(const DecimalComplex& written) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (written.bound == "inf") return {infinity, infinity};
  constexpr int guard_digits = 10;
  const Precision precision(static_cast<int>(std::max(written.re.size(), written.im.size())) + guard_digits);
  const auto [value, bound] = to_double(
      {BigComplex(parse<BigReal>(written.re), parse<BigReal>(written.im)), parse<BigReal>(written.bound)});
  return {value, bound};
}

}  // namespace fde::reference
