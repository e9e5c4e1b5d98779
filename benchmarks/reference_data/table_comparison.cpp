// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/reference_data/table_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::bench {

namespace {

constexpr int max_digits = 1000;
constexpr int guard_digits = 20;

DecimalPrecision number_at(const DataTable& table, std::size_t row, std::size_t column) {
  const auto& text = table.rows[row][column];
  const auto number = decimal_precision(text);
  if (number && number->digits <= max_digits) return *number;
  throw InvalidTable(fmt::format("{}: '{}' must be a decimal number of at most {} digits",
                                 table.place(row, table.columns[column]), text, max_digits));
}

reference::BigReal power_of_ten(int exponent) { return pow(reference::BigReal(10), exponent); }

std::string shown(const reference::BigReal& x) { return x == 0 ? "0" : reference::to_text(x, "%.*Re", 2); }

// Half a unit in the last place of the double nearest to x.
reference::BigReal rounding_to_double(const reference::BigReal& x) {
  constexpr int digits = std::numeric_limits<double>::digits;
  int exponent = std::numeric_limits<double>::min_exponent;
  if (x != 0) frexp(x, &exponent);
  return ldexp(reference::BigReal(1),
               std::max(exponent, std::numeric_limits<double>::min_exponent) - digits - 1);
}

std::optional<double> double_of(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc{}) return std::nullopt;
  return value;
}

// The value and its tolerance without a bound: half a unit of the last place, plus the rounding to double for
// 16 or 17 digits.
std::pair<reference::BigReal, reference::BigReal> meant_by(const std::string& text,
                                                           const DecimalPrecision& written, int digits,
                                                           int last_place) {
  const int place = written.digits == 0 ? last_place : std::max(written.first_place - digits + 1, last_place);
  const reference::BigReal value = reference::parse<reference::BigReal>(text), half = power_of_ten(place) / 2;
  const auto number = double_of(text);
  if (!number || (digits != 16 && digits != 17)) return {value, half};
  const reference::BigReal of_double = rounding_to_double(value);
  if (digits == 17 && half < of_double) return {reference::BigReal(*number), of_double};
  return {value, reference::BigReal(std::max(half, of_double) + of_double)};
}

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

struct TableComparison::ToleratedValue {
  reference::BigReal value, allowed;
};

TableComparison::TableComparison(const DataTable& given, const std::vector<std::string>& value_columns)
    : given_(given), bound_(given.find("bound")) {
  for (std::size_t value = 0; value < value_columns.size(); ++value) {
    const auto at = given.find(value_columns[value]);
    if (!at) continue;
    columns_.push_back({*at, value, 0, std::numeric_limits<int>::max()});
    read(columns_.back());
    digits_ = std::max(digits_, columns_.back().digits);
  }
  if (columns_.empty()) {
    throw InvalidTable(
        fmt::format("{}: has none of the columns {}", given.name, fmt::join(value_columns, ", ")));
  }
  for (std::size_t row = 0; bound_ && row < given.rows.size(); ++row) {
    number_at(given, row, *bound_);
    const auto& text = given.rows[row][*bound_];
    if (!text.starts_with('-')) continue;
    throw InvalidTable(fmt::format("{}: {} must not be negative", given.place(row, "bound"), text));
  }
}

void TableComparison::read(Column& column) const {
  for (std::size_t row = 0; row < given_.rows.size(); ++row) {
    const auto number = number_at(given_, row, column.at);
    column.digits = std::max(column.digits, number.digits);
    column.last_place = std::min(column.last_place, number.last_place);
  }
}

TableComparison::ToleratedValue TableComparison::tolerated_value(std::size_t row,
                                                                 const Column& column) const {
  const auto& text = given_.rows[row][column.at];
  if (bound_) {
    const auto& bound = given_.rows[row][*bound_];
    const auto allowed = reference::parse<reference::BigReal>(bound);
    if (!std::isfinite(allowed.convert_to<double>()))
      throw std::runtime_error(fmt::format("a bound of {} says nothing of a value", bound));
    return {reference::parse<reference::BigReal>(text), allowed};
  }
  const auto [value, allowed] =
      meant_by(text, number_at(given_, row, column.at), column.digits, column.last_place);
  return {value, allowed};
}

RowComparison TableComparison::operator()(std::size_t row,
                                          const std::vector<reference::Decimal>& recomputed) const {
  const reference::Precision precision(digits_ + guard_digits);
  RowComparison worst;
  for (const auto& column : columns_) {
    const auto& [value, bound] = recomputed[column.value];
    const auto [given, own] = tolerated_value(row, column);
    const reference::BigReal error =
                                 abs(reference::BigReal(given - reference::parse<reference::BigReal>(value))),
                             allowed = own + reference::parse<reference::BigReal>(bound);
    // A ratio just above 1 must not round to 1 in double.
    double ratio = error == 0 ? 0.0 : reference::BigReal(error / allowed).convert_to<double>();
    if (error > allowed) ratio = std::max(ratio, 1.0 + std::numeric_limits<double>::epsilon());
    if (worst.column.empty() || ratio > worst.ratio)
      worst = {given_.columns[column.at], shown(error), shown(allowed), ratio};
  }
  return worst;
}

void TableComparison::require_accurate(std::size_t row, const std::vector<reference::Decimal>& recomputed,
                                       int digits) const {
  const reference::Precision precision(digits_ + guard_digits);
  reference::BigReal size = 0;
  for (const auto& [value, bound] : recomputed)
    size = std::max(size, reference::BigReal(abs(reference::parse<reference::BigReal>(value))));
  const reference::BigReal small = size * power_of_ten(-digits);
  for (const auto& column : columns_) {
    const auto& [value, bound] = recomputed[column.value];
    if (const auto known_to = reference::parse<reference::BigReal>(bound);
        known_to > small && known_to > tolerated_value(row, column).allowed) {
      throw std::runtime_error(
          fmt::format("no value to compare {} with: recomputed as {}, with a bound of {}",
                      given_.columns[column.at], value, bound));
    }
  }
}

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
