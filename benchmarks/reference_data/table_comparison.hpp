// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/reference_data/data_table.hpp"
#include "fdebench/reference/reference.hpp"

namespace fde::bench {

// The comparison of one row with recomputed values: its column with the largest ratio of error to tolerance.
struct RowComparison {
  std::string column{};
  std::string error{}, allowed{};  // decimals of three digits
  double ratio = 0.0;              // error / allowed
  std::string failure{};           // why there is no recomputed value; empty if there is one
  [[nodiscard]] bool holds() const { return failure.empty() && ratio <= 1.0; }
};

// Compares the values of a table with recomputed values. The tolerance of a value is the bound in its row
// plus the bound of the recomputed value. Without a column `bound` the decimal text gives the tolerance: half
// a unit of the last place. This place is given by the largest number of significant digits, or of decimals,
// of any value in the column, whichever is coarser (so 0.5 among values of twelve digits counts as
// 0.500000000000). 17 digits denote the nearest double, with a tolerance of half a unit of its last place;
// with 16 digits that half unit is added.
class TableComparison {
 public:
  // Compares those of `value_columns` that the table has; the table must outlive this object. Throws
  // std::invalid_argument if it has none of them, or naming a cell that is not a number of at most 1000
  // digits or is a negative bound.
  TableComparison(const DataTable& given, const std::vector<std::string>& value_columns);

  // Largest number of significant digits of any value.
  [[nodiscard]] int digits() const { return digits_; }

  // `recomputed`: one element per value column, in the order of the constructor's argument. Throws
  // std::runtime_error if the bound in the row overflows double.
  [[nodiscard]] RowComparison operator()(std::size_t row,
                                         const std::vector<reference::Decimal>& recomputed) const;

  // Throws std::runtime_error if a recomputed value is too inaccurate for a comparison: its bound exceeds
  // both the tolerance of the given value and 10^-digits times the largest recomputed value.
  void require_accurate(std::size_t row, const std::vector<reference::Decimal>& recomputed, int digits) const;

 private:
  struct Column {
    std::size_t at, value;  // index in the table, index in the recomputed values
    int digits = 0;         // largest number of any row
    int last_place;         // lowest of any row
  };
  struct ToleratedValue;  // a value and its tolerance
  void read(Column& column) const;
  [[nodiscard]] ToleratedValue tolerated_value(std::size_t row, const Column& column) const;

  const DataTable& given_;
  std::vector<Column> columns_;
  std::optional<std::size_t> bound_;
  int digits_ = 0;
};

// The precision of a decimal number as written. Places are powers of ten: 12.50 has four digits, first place
// 1 and last place -2. Zero has no significant digit.
struct DecimalPrecision {
  int digits = 0;  // from the first nonzero digit to the last digit written
  int first_place = 0;
  int last_place = 0;
};

// nullopt if the text is no decimal number like -12.50 or 1e-9, or its exponent exceeds a million.
std::optional<DecimalPrecision> decimal_precision(std::string_view text);

}  // namespace fde::bench
