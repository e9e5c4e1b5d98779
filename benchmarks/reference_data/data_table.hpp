#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace fde {

// A file that is not what it should be: its message begins with the name of the file, and says line and
// column where there is one.
struct BadTable : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

// A table of texts under named columns, as it stands in a CSV file: the header in line 1, rows from line 2
// on.
struct DataTable {
  std::string name{};  // of the file, for messages
  std::vector<std::string> columns{};
  std::vector<std::vector<std::string>> rows{};

  // Where a column stands; nullopt: there is none of this name.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view column) const;

  // "NAME: line 7, column re", for messages about one cell.
  [[nodiscard]] std::string place(std::size_t row, std::string_view column) const;
};

// Throws std::invalid_argument naming the file when it cannot be read.
std::string read_file(const std::filesystem::path& file);

// RFC 4180 with \n, without quotes: no cell here has a comma.
std::string to_csv(const DataTable& table);

// Reads CSV of other programs too: \r\n, no last line end, a byte order mark, spaces round cells, quoted
// cells, empty lines at the end. Throws std::invalid_argument naming the table and line for an empty file, a
// row with another number of cells than the header, two columns of one name, and an open quote.
DataTable parse_csv(const std::string& name, std::string_view text);

}  // namespace fde
