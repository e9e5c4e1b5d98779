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

// The tables of exported results, with the columns that SQL creates. docs/results.md says what they mean.
struct SqlTable {
  std::string_view name, columns;
};
enum class TableId : std::size_t { sessions, scenes, parameters, runs, results, courses };
inline constexpr std::array exported_tables{
    SqlTable{
        "sessions",
        "session_id INTEGER PRIMARY KEY, date TEXT NOT NULL, machine TEXT NOT NULL, cores INTEGER NOT "
        "NULL, system TEXT NOT NULL, compiler TEXT NOT NULL, flags TEXT NOT NULL, revision TEXT NOT NULL, "
        "version TEXT NOT NULL, node TEXT, build_id INTEGER NOT NULL"},
    SqlTable{
        "scenes",
        "scene_id INTEGER PRIMARY KEY, scene TEXT NOT NULL, checksum TEXT, until REAL, title TEXT, source "
        "TEXT, evidence TEXT, reference_seconds REAL, description TEXT"},
    SqlTable{"parameters",
             "scene_id INTEGER NOT NULL REFERENCES scenes, parameter TEXT NOT NULL, number REAL, word TEXT, "
             "given INTEGER NOT NULL"},
    SqlTable{
        "runs",
        "run_id INTEGER PRIMARY KEY, session_id INTEGER NOT NULL REFERENCES sessions, scene_id INTEGER "
        "NOT NULL REFERENCES scenes, scheme TEXT NOT NULL, external INTEGER NOT NULL, code TEXT, "
        "code_version TEXT, language TEXT, steps INTEGER NOT NULL, h REAL NOT NULL, accuracy_relative "
        "REAL, accuracy_absolute REAL, grading REAL NOT NULL, history TEXT, tolerance REAL, budget REAL, "
        "ending TEXT, detail TEXT, ended_at REAL, latest INTEGER NOT NULL"},
    SqlTable{"results",
             "result_id INTEGER PRIMARY KEY, run_id INTEGER NOT NULL REFERENCES runs, session_id INTEGER NOT "
             "NULL REFERENCES sessions, quantity TEXT NOT NULL, value REAL NOT NULL, unit TEXT NOT NULL, "
             "wall_clock INTEGER NOT NULL"},
    SqlTable{"courses",
             "result_id INTEGER NOT NULL REFERENCES results, t REAL NOT NULL, value REAL NOT NULL"}};

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

// Writes the contents of a results file as rows of the tables. Throws as index_results and the writer do.
ExportCounts write_tables(const std::filesystem::path& file, TableWriter& writer);

}  // namespace fde::bench
