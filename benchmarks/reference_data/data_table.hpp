// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace fde::bench {

// A malformed file. The message begins with the name of the file and names line and column where applicable.
struct InvalidTable : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

// The cells of a CSV file as text, under named columns: the header in line 1, rows from line 2 on.
struct DataTable {
  std::string name{};  // of the file, for messages
  std::vector<std::string> columns{};
  std::vector<std::vector<std::string>> rows{};

  // Index of a column; nullopt if there is none of this name.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view column) const;

  // "NAME: line 7, column re", for messages about one cell.
  [[nodiscard]] std::string place(std::size_t row, std::string_view column) const;
};

// The content of a file. Throws std::invalid_argument naming the file if it cannot be read.
std::string read_file(const std::filesystem::path& file);

// RFC 4180 with \n, without quotes. Precondition: no cell contains a comma.
std::string to_csv(const DataTable& table);

// Parses CSV. Accepts \r\n, a missing last line end, a byte order mark, spaces around cells, quoted cells and
// empty lines at the end. Throws std::invalid_argument naming the table and line for an empty file, a row
// whose number of cells differs from the header's, two columns of one name, and an open quote.
DataTable parse_csv(const std::string& name, std::string_view text);

}  // namespace fde::bench
