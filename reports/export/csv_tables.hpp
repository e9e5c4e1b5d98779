// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "fdebench/reports/export/tables.hpp"

namespace fde::bench {

// A new folder with a file TABLE.csv for each table, as RFC 4180 has it: lines end with CR LF, quotes are
// doubled, numbers are those of the results file to the last bit, NULL is an empty field. `name` is the
// folder in messages.
class CsvTables : public TableWriter {
 public:
  CsvTables(const std::filesystem::path& folder, std::filesystem::path name);
  void add(TableId table, std::span<const Cell> row) override;
  void finish() override;

 private:
  void check(const std::ofstream& stream) const;

  std::filesystem::path name_;
  std::vector<std::ofstream> files_{};
  std::string line_{};
};

}  // namespace fde::bench
