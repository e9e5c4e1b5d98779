// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/reference_data/data_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "fdebench/benchmarks/text/printable.hpp"

namespace fde::bench {
namespace {

// The cell that starts at `begin`; advances `begin` past the cell and its comma, beyond the line after the
// last.
std::string next_cell(std::string_view line, std::size_t& begin) {
  std::string cell;
  bool quoted = false, was_quoted = false;
  std::size_t i = begin;
  for (; i < line.size() && (quoted || line[i] != ','); ++i) {
    if (line[i] != '"') {
      cell += line[i];
    } else if (quoted && i + 1 < line.size() && line[i + 1] == '"') {
      cell += line[i++];
    } else {
      quoted = !quoted;
      was_quoted = true;
    }
  }
  if (quoted) throw std::invalid_argument("a quoted cell has no end");
  begin = i + 1;
  return was_quoted ? cell : std::string(trimmed(cell));
}

std::vector<std::string> split_cells(std::string_view line) {
  std::vector<std::string> cells;
  for (std::size_t begin = 0; begin <= line.size();) cells.push_back(next_cell(line, begin));
  return cells;
}

std::vector<std::string_view> split_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const auto end = std::min(text.find('\n', begin), text.size());
    lines.push_back(trimmed(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  return lines;
}

void require_different(const std::vector<std::string>& columns) {
  for (auto column = columns.begin(); column != columns.end(); ++column) {
    if (!column->empty() && std::find(column + 1, columns.end(), *column) != columns.end())
      throw std::invalid_argument(fmt::format("column {} occurs twice", *column));
  }
}

}  // namespace

std::optional<std::size_t> DataTable::find(std::string_view column) const {
  const auto found = std::ranges::find(columns, column);
  if (found == columns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns.begin());
}

std::string DataTable::place(std::size_t row, std::string_view column) const {
  return fmt::format("{}: line {}, column {}", name, row + 2, column);
}

std::string read_file(const std::filesystem::path& file) {
  const auto cannot = [&](const std::string& reason) {
    return std::invalid_argument(fmt::format("{}: cannot be read: {}", file.string(), reason));
  };
  std::error_code problem;
  const auto status = std::filesystem::status(file, problem);  // opening a pipe would block
  if (std::filesystem::is_directory(status))
    throw cannot(std::make_error_code(std::errc::is_a_directory).message());
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw cannot("is not a file");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw cannot(std::generic_category().message(errno));
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string to_csv(const DataTable& table) {
  std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
  for (const auto& row : table.rows) text += fmt::format("{}\n", fmt::join(row, ","));
  return text;
}

DataTable parse_csv(const std::string& name, std::string_view text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  const auto lines = split_lines(text);
  if (lines.empty()) throw std::invalid_argument(fmt::format("{}: is empty, there is no header", name));
  DataTable table{.name = name};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    try {
      auto cells = split_cells(lines[i]);
      if (i == 0) {
        require_different(cells);
        table.columns = std::move(cells);
      } else if (cells.size() == table.columns.size()) {
        table.rows.push_back(std::move(cells));
      } else {
        throw std::invalid_argument(
            fmt::format("must have {} cells, as the header, not {}", table.columns.size(), cells.size()));
      }
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("{}: line {}: {}", name, i + 1, error.what()));
    }
  }
  return table;
}

}  // namespace fde::bench
