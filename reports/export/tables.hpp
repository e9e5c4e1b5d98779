// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace fde::bench {

// The tables of exported results, with the columns and types of SQL. docs/results.md says what they mean.
struct SqlColumn {
  std::string_view name, type;
};
struct SqlTable {
  std::string_view name;
  std::span<const SqlColumn> columns;
};
enum class TableId : std::size_t { sessions, scenes, parameters, runs, results, courses };
constexpr std::size_t table_count = 6;
const std::array<SqlTable, table_count>& tables();

// A value of a column; std::monostate is NULL. A text is valid during the call that passes it.
using Cell = std::variant<std::monostate, std::int64_t, double, std::string_view>;

// Where rows go. Each function throws std::invalid_argument naming the path if it cannot be written.
class TableWriter {
 public:
  virtual ~TableWriter() = default;
  virtual void add(TableId table, std::span<const Cell> row) = 0;
  virtual void finish() = 0;  // after the last row
};

// A new folder with a file TABLE.csv for each table, as RFC 4180 has it: lines end with CR LF, quotes are
// doubled, numbers are those of the results file to the last bit, NULL is an empty field. `name` is the
// folder in messages.
std::unique_ptr<TableWriter> csv_tables(const std::filesystem::path& folder,
                                        const std::filesystem::path& name);

// A new SQLite database with the tables, their keys and indices, and the view `measurements`. `name` is the
// file in messages.
std::unique_ptr<TableWriter> sqlite_tables(const std::filesystem::path& file,
                                           const std::filesystem::path& name);

struct ExportCounts {
  std::size_t sessions = 0, scenes = 0, runs = 0, results = 0;
  std::string warning{};  // of lines that are left out
};

// Writes the contents of a results file as rows of the tables. Throws as read_results and the writer do.
ExportCounts write_tables(const std::filesystem::path& file, TableWriter& writer);

}  // namespace fde::bench
