#include "fdebench/benchmarks/reference_data/table_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/reference_data/decimal_precision.hpp"
#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde {
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

BigReal power_of_ten(int exponent) { return pow(BigReal(10), exponent); }

std::string shown(const BigReal& x) { return x == 0 ? "0" : to_text(x, "%.*Re", 2); }

// Half a unit in the last place of the double nearest to x.
BigReal rounding_to_double(const BigReal& x) {
  constexpr int digits = std::numeric_limits<double>::digits;
  int exponent = std::numeric_limits<double>::min_exponent;
  if (x != 0) frexp(x, &exponent);
  return ldexp(BigReal(1), std::max(exponent, std::numeric_limits<double>::min_exponent) - digits - 1);
}

std::optional<double> double_of(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc{}) return std::nullopt;
  return value;
}

// The value and its tolerance without a bound: half a unit of the last place, plus the rounding to double for
// 16 or 17 digits.
std::pair<BigReal, BigReal> meant_by(const std::string& text, const DecimalPrecision& written, int digits,
                                     int last_place) {
  const int place = written.digits == 0 ? last_place : std::max(written.first_place - digits + 1, last_place);
  const BigReal value = parse<BigReal>(text), half = power_of_ten(place) / 2;
  const auto number = double_of(text);
  if (!number || (digits != 16 && digits != 17)) return {value, half};
  const BigReal of_double = rounding_to_double(value);
  if (digits == 17 && half < of_double) return {BigReal(*number), of_double};
  return {value, BigReal(std::max(half, of_double) + of_double)};
}

}  // namespace

struct TableComparison::Meant {
  BigReal value, allowed;
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

TableComparison::Meant TableComparison::meant(std::size_t row, const Column& column) const {
  const auto& text = given_.rows[row][column.at];
  if (bound_) {
    const auto& bound = given_.rows[row][*bound_];
    const auto allowed = parse<BigReal>(bound);
    if (!std::isfinite(allowed.convert_to<double>()))
      throw std::runtime_error(fmt::format("a bound of {} says nothing of a value", bound));
    return {parse<BigReal>(text), allowed};
  }
  const auto [value, allowed] =
      meant_by(text, number_at(given_, row, column.at), column.digits, column.last_place);
  return {value, allowed};
}

RowComparison TableComparison::operator()(std::size_t row, const std::vector<Decimal>& recomputed) const {
  const Precision precision(digits_ + guard_digits);
  RowComparison worst;
  for (const auto& column : columns_) {
    const auto& [value, bound] = recomputed[column.value];
    const auto [given, own] = meant(row, column);
    const BigReal error = abs(BigReal(given - parse<BigReal>(value))), allowed = own + parse<BigReal>(bound);
    // A ratio just above 1 must not round to 1 in double.
    double ratio = error == 0 ? 0.0 : BigReal(error / allowed).convert_to<double>();
    if (error > allowed) ratio = std::max(ratio, 1.0 + std::numeric_limits<double>::epsilon());
    if (worst.column.empty() || ratio > worst.ratio)
      worst = {given_.columns[column.at], shown(error), shown(allowed), ratio};
  }
  return worst;
}

void TableComparison::require_accurate(std::size_t row, const std::vector<Decimal>& recomputed,
                                       int digits) const {
  const Precision precision(digits_ + guard_digits);
  BigReal size = 0;
  for (const auto& [value, bound] : recomputed) size = std::max(size, BigReal(abs(parse<BigReal>(value))));
  const BigReal small = size * power_of_ten(-digits);
  for (const auto& column : columns_) {
    const auto& [value, bound] = recomputed[column.value];
    if (const auto known_to = parse<BigReal>(bound);
        known_to > small && known_to > meant(row, column).allowed) {
      throw std::runtime_error(
          fmt::format("no value to compare {} with: recomputed as {}, with a bound of {}",
                      given_.columns[column.at], value, bound));
    }
  }
}

}  // namespace fde
