// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/reference_data/data_table.hpp"
#include "fdebench/benchmarks/reference_data/table_comparison.hpp"
#include "fdebench/benchmarks/sweep/sweep.hpp"

namespace fde::bench {

inline constexpr int table_digits = 50;   // of values with an exact solution
inline constexpr int double_digits = 17;  // of values in double
inline constexpr int more_digits = 3;     // extra digits of a recomputed value

enum class ColumnType { number, integer, text };

struct TableColumn {
  std::string name, description;
  std::string unit = "1";  // scenes and functions here are dimensionless
  ColumnType type = ColumnType::number;
  bool required = true;   // a table without this column is rejected
  bool argument = false;  // the arguments of a row determine its values
  std::optional<int> minimum{}, maximum{};
};

// Metadata of a table.
struct TableMetadata {
  std::string title, method, source, bound;
  int digits = 0;
  std::vector<TableColumn> columns{};
};

// A run without a row in the table, and why.
struct OmittedRun {
  std::string run, reason;
};

struct ComputedTable {
  DataTable table{};
  std::vector<OmittedRun> left_out{};
};

// Recomputes one row and compares it. Throws std::invalid_argument for arguments out of range, and
// std::runtime_error if the value cannot be computed.
using RowCheck = std::function<RowComparison(std::size_t row)>;

// One kind of table of the reference data: the meaning of its columns, how to compute its rows and how to
// check a row. `of` is the scene and its parameters; tables of functions have none (factory = nullptr).
struct TableKind {
  std::string_view id;
  std::string_view folder;  // of the tables, one per scene; empty: one table, named after the kind
  std::string_view identifying_column;  // name of a column that no other kind has
  TableMetadata (*facts)(const SceneVariant& of);
  ComputedTable (*make)(const SceneVariant& of);
  // `given` must outlive the result. Throws std::invalid_argument for malformed cells, std::runtime_error if
  // the scene has no reference.
  RowCheck (*check)(const SceneVariant& of, const DataTable& given);

  // Whether there is a table for this scene; nullptr: for all scenes.
  bool (*has_table)(const SceneVariant& of) = nullptr;

  [[nodiscard]] bool of_scenes() const { return !folder.empty(); }
};

std::span<const TableKind> table_kinds();

extern const TableKind mittag_leffler_table, trajectory_table, convergence_table;

}  // namespace fde::bench
