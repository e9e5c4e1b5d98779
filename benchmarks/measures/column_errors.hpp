// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fdebench/benchmarks/measures/by_quantity.hpp"

namespace fde::bench {

struct FinishedRun;
struct Measure;

// The columns that the errors of a run are over, and the errors of each column alone, so that runs that were
// judged over different columns can be compared over those that both have.
struct ColumnErrors {
  std::vector<std::string> names{};          // empty: not recorded
  bool is_part = false;                      // the scene has other columns, too
  ByQuantity<std::vector<double>> values{};  // by measure, an entry a column; may be empty

  bool operator==(const ColumnErrors&) const = default;
};

// Of more columns only the names are recorded.
inline constexpr std::size_t most_single_columns = 8;

// Each error, each baseline and each unresolved variation of every column alone; the baseline of a constant
// column is 0. `names`: those of the run's columns.
ColumnErrors column_errors(const FinishedRun& run, std::vector<std::string> names, bool is_part);

// The measures over several of these columns: the errors, the baselines that are no larger than their error,
// and the variations that are larger; nullopt where there is none. Empty if a column is not among them or its
// errors are not recorded. The baseline is at most the true one, because y = 0 or y = y(0) is chosen for each
// column.
using MeasuresOfColumns = std::map<std::string, std::optional<double>>;
MeasuresOfColumns measures_of_columns(const ColumnErrors& all, const std::vector<std::string>& columns);

// The error of each kind, then its constant-solution baseline of each kind, in the order of error_kinds; then
// the unresolved variation of each scale.
std::span<const Measure> error_measures();

}  // namespace fde::bench
