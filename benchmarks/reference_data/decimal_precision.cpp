// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/reference_data/decimal_precision.hpp"

#include <algorithm>
#include <charconv>
#include <string>

namespace fde::bench {
namespace {

constexpr std::string_view decimal_digits = "0123456789";
constexpr int largest_exponent = 1'000'000;

std::string_view without_sign(std::string_view text) {
  return text.substr(text.starts_with('+') || text.starts_with('-') ? 1 : 0);
}

std::optional<int> read_exponent(std::string_view text) {
  const auto digits = without_sign(text);
  if (digits.empty() || digits.find_first_not_of(decimal_digits) != std::string_view::npos)
    return std::nullopt;
  int exponent = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  if (result.ec != std::errc{} || exponent > largest_exponent) return std::nullopt;
  return text.starts_with('-') ? -exponent : exponent;
}

}  // namespace

std::optional<DecimalPrecision> decimal_precision(std::string_view text) {
  text = without_sign(text);
  const auto e = std::min(text.find_first_of("eE"), text.size());
  const auto exponent = e == text.size() ? 0 : read_exponent(text.substr(e + 1));
  std::string digits(text.substr(0, e));
  const auto point = std::min(digits.find('.'), digits.size());
  if (point < digits.size()) digits.erase(point, 1);
  if (!exponent || digits.empty() || digits.find_first_not_of(decimal_digits) != std::string::npos)
    return std::nullopt;
  const auto size = static_cast<int>(digits.size()), before = static_cast<int>(point);
  const auto zeros = static_cast<int>(std::min(digits.find_first_not_of('0'), digits.size()));
  const int last = before - size + *exponent;
  return DecimalPrecision{
      .digits = size - zeros,
      .first_place = zeros == size ? last : before - 1 - zeros + *exponent,
      .last_place = last,
  };
}

}  // namespace fde::bench
