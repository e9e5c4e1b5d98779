// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "fdebench/reports/export/tables.hpp"

struct sqlite3;
struct sqlite3_stmt;

namespace fde::bench {

// A new SQLite database with the tables, their keys and indices, and the view `measurements`. `name` is the
// file in messages.
class SqliteTables : public TableWriter {
 public:
  SqliteTables(const std::filesystem::path& file, std::filesystem::path name);
  void add(TableId table, std::span<const Cell> row) override;
  void finish() override;

 private:
  struct Close {
    void operator()(sqlite3* database) const;
    void operator()(sqlite3_stmt* statement) const;
  };
  void run(const std::string& sql);
  void check(int code) const;

  std::filesystem::path name_;
  std::unique_ptr<sqlite3, Close> database_;
  std::vector<std::unique_ptr<sqlite3_stmt, Close>> inserts_{};  // by table
};

}  // namespace fde::bench
