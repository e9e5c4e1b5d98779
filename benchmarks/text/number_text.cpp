// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/text/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <system_error>

#include "fdebench/benchmarks/text/range.hpp"

namespace fde::bench {
namespace {

// Parses the whole text; nullopt if it is not a number or is out of the range of the type (`error` says
// which).
template <typename Number>
std::optional<Number> read(std::string_view text, std::errc* error = nullptr) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number number{};
  const auto [end, found] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (end != text.data() + text.size()) return std::nullopt;
  if (error != nullptr) *error = found;
  return found == std::errc{} ? std::optional(number) : std::nullopt;
}

bool out_of_range(std::string_view text) {
  std::errc error{};
  return !read<double>(text, &error) && error == std::errc::result_out_of_range;
}

// Whether a decimal number out of the range of double underflows: the power of ten of its first digit
// decides.
bool is_small(std::string_view text) {
  const auto e = std::min(text.find_first_of("eE"), text.size());
  const auto mantissa = text.substr(0, e);
  const auto point = std::min(mantissa.find('.'), mantissa.size()),
             first = mantissa.find_first_of("123456789");
  const auto places = static_cast<double>(point) - static_cast<double>(first);
  // an exponent beyond int is far beyond the places
  auto exponent = e < text.size() ? text.substr(e + 1) : "0";
  const bool negative = exponent.starts_with('-');
  const auto size = read<int>(exponent.starts_with('+') || negative ? exponent.substr(1) : exponent);
  if (!size) return negative;
  return places + (negative ? -*size : *size) <= 0.0;
}

}  // namespace

bool is_decimal(std::string_view text) {
  const auto number = try_parse_number(text);
  return number ? std::isfinite(*number) : out_of_range(text);
}

std::string double_range_message(std::string_view text) {
  using Double = std::numeric_limits<double>;
  if (!out_of_range(text)) return {};
  return is_small(text)
             ? fmt::format("underflows double, whose least number is {:.2g}, and ", Double::denorm_min())
             : fmt::format("overflows double, whose largest number is {:.2g}, and ", Double::max());
}

void reject_text(std::string_view name, std::string_view text, std::string_view allowed) {
  throw Refusal({RequestField{std::string(name)},
                 fmt::format(" = {}: {}must be {}", text, double_range_message(text), allowed)});
}

std::optional<double> try_parse_number(std::string_view text) { return read<double>(text); }

std::optional<std::vector<double>> try_parse_numbers(std::string_view text) {
  std::vector<double> numbers;
  if (text.empty()) return numbers;
  for (const auto& part : split_list(text)) {
    const auto number = try_parse_number(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

double parse_number(std::string_view name, std::string_view text, const Range& allowed) {
  const auto value = try_parse_number(text);
  if (!value) reject_text(name, text, allowed.text());
  if (!allowed.contains(*value)) reject_text(name, fmt::format("{}", *value), allowed.text());
  return *value;
}

int parse_count(std::string_view name, std::string_view text, int lowest, int highest) {
  const auto value = read<int>(text);
  if (!value || *value < lowest || *value > highest) {
    reject_text(name, text, CountRange{lowest, highest}.text());
  }
  return *value;
}

std::vector<std::string> split_list(std::string_view text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find(',', begin), text.size());
    parts.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

namespace {

// units * 10^place, exactly.
struct ExactDecimal {
  std::int64_t units = 0;
  int place = 0;
};

// At most 15 digits; nullopt if the text has more or is not a decimal.
std::optional<ExactDecimal> exact_decimal(std::string_view text) {
  constexpr std::size_t max_digits = 15;
  if (!is_decimal(text)) return std::nullopt;
  const auto e = std::min(text.find_first_of("eE"), text.size());
  std::string digits(text.substr(text.starts_with('+') ? 1 : 0, e - (text.starts_with('+') ? 1 : 0)));
  const auto exponent = e < text.size() ? read<int>(text.substr(e + 1)) : 0;
  int place = exponent.value_or(0);
  if (const auto point = digits.find('.'); point != std::string::npos) {
    place -= static_cast<int>(digits.size() - point) - 1;
    digits.erase(point, 1);
  }
  while (place < 0 && digits.ends_with('0') && digits.size() > 1) {
    digits.pop_back();
    ++place;
  }
  const auto units = read<std::int64_t>(digits);
  if (!exponent || !units || digits.size() - (digits.starts_with('-') ? 1 : 0) > max_digits)
    return std::nullopt;
  return ExactDecimal{*units, place};
}

// x in units of 10^place; nullopt if the count of units is too large.
std::optional<std::int64_t> in_units(const ExactDecimal& x, int place) {
  constexpr std::int64_t most = 1'000'000'000'000'000;
  std::int64_t units = x.units;
  for (int k = x.place; k > place; --k) {
    if (std::abs(units) > most) return std::nullopt;
    units *= 10;
    if (units == 0) return 0;
  }
  return units;
}

}  // namespace

std::vector<std::string> expand_decimal_range(std::string_view name, std::string_view text,
                                              std::size_t most) {
  const auto refuse = [&](std::string_view allowed) { reject_text(name, text, allowed); };
  std::vector<ExactDecimal> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find(':', begin), text.size());
    const auto part = exact_decimal(text.substr(begin, end - begin));
    if (!part) refuse("FIRST:LAST:STEP, decimals of at most 15 digits");
    parts.push_back(*part);
    begin = end + 1;
  }
  if (parts.size() != 3) refuse("FIRST:LAST:STEP, decimals of at most 15 digits");
  const int place = std::ranges::min(parts, {}, &ExactDecimal::place).place;
  const auto first = in_units(parts[0], place), last = in_units(parts[1], place),
             step = in_units(parts[2], place);
  if (!first || !last || !step) refuse("FIRST:LAST:STEP of sizes that are not so far apart");
  if (*step == 0 || (*last < *first) != (*step < 0))
    refuse("FIRST:LAST:STEP with a step from FIRST towards LAST");
  const auto count = static_cast<std::size_t>((*last - *first) / *step) + 1;
  if (count > most) refuse(fmt::format("a range of at most {} values, not {}", most, count));
  std::vector<std::string> decimals;
  for (std::size_t k = 0; k < count; ++k)
    decimals.push_back(fmt::format("{}e{}", *first + static_cast<std::int64_t>(k) * *step, place));
  return decimals;
}

std::vector<double> parse_numbers(std::string_view name, std::string_view text, const Range& allowed) {
  std::vector<double> numbers;
  for (const auto& part : split_list(text)) {
    if (!is_decimal(part))
      reject_text(name, part, fmt::format("{}, or several with commas between them", allowed.text()));
    numbers.push_back(parse_number(name, part, allowed));
  }
  return numbers;
}

}  // namespace fde::bench
