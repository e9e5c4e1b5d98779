#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reference.hpp"
#include "reference_data/data_table.hpp"

namespace fde {

// One row against what was recomputed: the column with the largest ratio of error to what is allowed.
struct RowVerdict {
  std::string column{};
  std::string error{}, allowed{};  // decimals of three digits
  double ratio = 0.0;              // error / allowed
  std::string failure{};           // why there is nothing to compare with; empty: there is
  [[nodiscard]] bool holds() const { return failure.empty() && ratio <= 1.0; }
};

// Compares the values of a table with recomputed ones. A written value may be off by the bound in its row and
// the bound of the recomputed value together. Without a column `bound` the writing decides: half a unit of
// the last place, which is that of the most significant digits that any value of the column has, or of the
// most decimals, whichever is coarser (so 0.5 among values of twelve digits counts as 0.500000000000). 17
// digits mean the nearest double, which may be off by half a unit of its own last place; 16 are off by that
// besides.
class TableComparison {
 public:
  // Of those value columns that the table has; the table must live as long. Throws std::invalid_argument
  // where there is none, and naming the cell that is not a number of at most 1000 digits, or a negative
  // bound.
  TableComparison(const DataTable& given, const std::vector<std::string>& value_columns);

  // The most significant digits of any value.
  [[nodiscard]] int digits() const { return digits_; }

  // recomputed: one a value column, in their order, as are those below. Both throw std::runtime_error where
  // the bound in the row is beyond double.
  [[nodiscard]] RowVerdict operator()(std::size_t row, const std::vector<Decimal>& recomputed) const;

  // What is known too badly decides nothing. Throws std::runtime_error where the bound of a recomputed value
  // is larger than what the given one may be off by, and than 10^-digits of the largest recomputed value.
  void require_known(std::size_t row, const std::vector<Decimal>& recomputed, int digits) const;

 private:
  struct Column {
    std::size_t at, value;  // in the table, in the recomputed values
    int digits = 0;         // the most of any row
    int last_place;         // the lowest of any row
  };
  struct Meant;  // a value, and what it may be off by
  void read(Column& column) const;
  [[nodiscard]] Meant meant(std::size_t row, const Column& column) const;

  const DataTable& given_;
  std::vector<Column> columns_;
  std::optional<std::size_t> bound_;
  int digits_ = 0;
};

}  // namespace fde
