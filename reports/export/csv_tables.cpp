// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/files/unfinished.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"
#include "fdebench/reports/export/csv_cell.hpp"
#include "fdebench/reports/export/tables.hpp"

namespace fde::bench {
namespace {

void append(std::string& line, std::string_view text) {
  if (text.find_first_of("\",\r\n") == std::string_view::npos) {
    line += text;
    return;
  }
  line += '"';
  for (const char c : text) line.append(c == '"' ? 2 : 1, c);
  line += '"';
}

class CsvTables : public TableWriter {
 public:
  CsvTables(const std::filesystem::path& folder, std::filesystem::path name) : name_(std::move(name)) {
    std::error_code problem;
    std::filesystem::create_directory(folder, problem);
    if (problem) cannot_write(name_, problem);
    for (const SqlTable& table : exported_tables) {
      auto& file = files_.emplace_back(folder / fmt::format("{}.csv", table.name), std::ios::binary);
      std::string_view separator;
      for (const auto& column : split_list(table.columns)) {
        const auto declared = trimmed(column);
        file << std::exchange(separator, ",") << declared.substr(0, declared.find(' '));
      }
      file << csv_line_end;
      check(file);
    }
  }

  void add(TableId table, std::span<const Cell> row) override {
    line_.clear();
    for (const Cell& cell : row) {
      if (&cell != row.data()) line_ += ',';
      append_csv(line_, cell);
    }
    line_ += csv_line_end;
    auto& file = files_[static_cast<std::size_t>(table)];
    file.write(line_.data(), static_cast<std::streamsize>(line_.size()));
    check(file);
  }

  void finish() override {
    for (auto& file : files_) {
      file.close();
      check(file);
    }
  }

 private:
  void check(const std::ofstream& stream) const {
    if (!stream) cannot_write(name_, {errno, std::generic_category()});
  }

  std::filesystem::path name_;
  std::vector<std::ofstream> files_{};
  std::string line_{};
};

}  // namespace

void append_csv(std::string& line, const Cell& cell) {
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) {
    fmt::format_to(std::back_inserter(line), "{}", *whole);
  } else if (const auto* number = std::get_if<double>(&cell)) {
    fmt::format_to(std::back_inserter(line), "{}", *number);
  } else if (const auto* text = std::get_if<std::string_view>(&cell)) {
    append(line, *text);
  }
}

std::unique_ptr<TableWriter> csv_tables(const std::filesystem::path& folder,
                                        const std::filesystem::path& name) {
  return std::make_unique<CsvTables>(folder, name);
}

}  // namespace fde::bench
