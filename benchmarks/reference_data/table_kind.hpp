#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reference_data/comparison.hpp"
#include "reference_data/data_table.hpp"
#include "sweep/sweep.hpp"

namespace fde {

enum class ColumnType { number, integer, text };

struct TableColumn {
  std::string name, meaning;
  std::string unit = "1";  // scenes and functions here are dimensionless
  ColumnType type = ColumnType::number;
  bool required = true;  // in tables of other programs
};

// What a table is, besides its rows.
struct TableFacts {
  std::string title, method, source, bound;
  int digits = 0;
  std::vector<TableColumn> columns{};
};

// What has no row although it was to be computed, and why.
struct LeftOut {
  std::string run, reason;
};

struct MadeTable {
  DataTable table{};
  std::vector<LeftOut> left_out{};
};

// Recomputes one row. Throws std::invalid_argument for arguments outside what is allowed, and
// std::runtime_error where there is no value.
using RowCheck = std::function<RowVerdict(std::size_t row)>;

// One kind of table of the reference data: what its columns mean, how its rows are made and how a row is
// verified. `of` is the scene and its parameters; tables of functions have none (maker = nullptr).
struct TableKind {
  std::string_view id;
  std::string_view folder;    // of its tables, one a scene; empty: one table named after the kind
  std::string_view known_by;  // a column that no other kind has
  TableFacts (*facts)(const SceneVariant& of);
  MadeTable (*make)(const SceneVariant& of);
  // The table must live as long. Throws std::invalid_argument for malformed cells, std::runtime_error where
  // the scene has no reference.
  RowCheck (*check)(const SceneVariant& of, const DataTable& given);

  // Of which scenes there are tables; empty: of all.
  bool (*has_table)(const SceneVariant& of) = nullptr;

  [[nodiscard]] bool of_scenes() const { return !folder.empty(); }
};

std::span<const TableKind> table_kinds();

extern const TableKind mittag_leffler_table, trajectory_table, convergence_table;

}  // namespace fde
