// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <sqlite3.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/files/unfinished.hpp"
#include "fdebench/reports/export/tables.hpp"

namespace fde::bench {
namespace {

// A database that is renamed when it is complete needs no journal, and no waiting for the disk.
constexpr auto settings = "PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; BEGIN";

// Indices are quicker made at the end.
constexpr auto indices_and_view = R"(
CREATE UNIQUE INDEX parameters_of_scenes ON parameters (scene_id, parameter);
CREATE INDEX runs_of_scenes ON runs (scene_id, scheme);
CREATE INDEX results_of_runs ON results (run_id, quantity);
CREATE INDEX results_by_quantity ON results (quantity, value);
CREATE INDEX courses_of_results ON courses (result_id, t);
CREATE VIEW measurements AS
  SELECT scene, until, checksum, scheme, external, steps, h, accuracy_relative, accuracy_absolute, grading, history,
    tolerance, budget, ending, latest, quantity, value, unit, wall_clock, machine, revision, result_id, run_id,
    scene_id, results.session_id
  FROM results JOIN runs USING (run_id) JOIN scenes USING (scene_id) JOIN sessions ON sessions.session_id = results.session_id;
COMMIT)";

std::string insertion(const SqlTable& table) {
  std::string places = "?";
  for (const char c : table.columns)
    if (c == ',') places += ", ?";
  return fmt::format("INSERT INTO {} VALUES ({})", table.name, places);
}

int bind(sqlite3_stmt* statement, int place, const Cell& cell) {
  if (const auto* whole = std::get_if<std::int64_t>(&cell))
    return sqlite3_bind_int64(statement, place, *whole);
  if (const auto* number = std::get_if<double>(&cell)) return sqlite3_bind_double(statement, place, *number);
  const auto* text = std::get_if<std::string_view>(&cell);
  if (text == nullptr) return sqlite3_bind_null(statement, place);
  const char* const begin = text->empty() ? "" : text->data();  // a null pointer would be NULL
  return sqlite3_bind_text(statement, place, begin, static_cast<int>(text->size()), nullptr);
}

class SqliteTables : public TableWriter {
 public:
  SqliteTables(const std::filesystem::path& file, std::filesystem::path name) : name_(std::move(name)) {
    sqlite3* opened = nullptr;
    const int code =
        sqlite3_open_v2(file.c_str(), &opened, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
    database_.reset(opened);
    check(code);
    run(settings);
    for (const SqlTable& table : exported_tables) {
      run(fmt::format("CREATE TABLE {} ({})", table.name, table.columns));
      sqlite3_stmt* insert = nullptr;
      check(sqlite3_prepare_v2(opened, insertion(table).c_str(), -1, &insert, nullptr));
      inserts_.emplace_back(insert);
    }
  }

  void add(TableId table, std::span<const Cell> row) override {
    sqlite3_stmt* const insert = inserts_[static_cast<std::size_t>(table)].get();
    int place = 0;
    for (const Cell& cell : row) check(bind(insert, ++place, cell));
    const int code = sqlite3_step(insert);
    check(code == SQLITE_DONE ? SQLITE_OK : code);
    check(sqlite3_reset(insert));
  }

  void finish() override {
    inserts_.clear();
    run(indices_and_view);
    check(sqlite3_close(database_.release()));
  }

 private:
  struct Close {
    void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };

  void run(const std::string& sql) {
    check(sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr));
  }

  void check(int code) const {
    if (code == SQLITE_OK) return;
    if (code == SQLITE_NOMEM) throw std::bad_alloc();
    const int reason = sqlite3_system_errno(database_.get());
    if (reason != 0) cannot_write(name_, {reason, std::generic_category()});
    throw std::invalid_argument(
        fmt::format("{}: cannot be written: {}", name_.string(), sqlite3_errstr(code)));
  }

  std::filesystem::path name_;
  std::unique_ptr<sqlite3, Close> database_;
  std::vector<std::unique_ptr<sqlite3_stmt, Close>> inserts_{};  // by table
};

}  // namespace

std::unique_ptr<TableWriter> sqlite_tables(const std::filesystem::path& file,
                                           const std::filesystem::path& name) {
  return std::make_unique<SqliteTables>(file, name);
}

}  // namespace fde::bench
