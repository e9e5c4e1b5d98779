#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "reference_data/comparison.hpp"
#include "reference_data/reference_folder.hpp"

namespace fde {

// What a check found about one table.
struct TableVerdict {
  std::string table{};  // file name in the folder
  std::size_t rows = 0, recomputed = 0, wrong = 0;
  std::size_t worst_line = 0;  // in the file, of the row with the largest ratio
  std::string worst_row{};     // its cells
  RowVerdict worst{};
  bool described = false;             // by a JSON; without it what the table is of is a guess
  std::vector<std::string> absent{};  // what the folder does not say, and what was taken for it
};

struct FolderVerdict {
  std::vector<TableVerdict> tables{};
  std::set<std::string> changed{};  // files whose checksum, of those that are there, is another
};

// Recomputes each `every`-th row of every table in a folder, from the first one on. The folder may come from
// another program: tables are known by their columns and named after their scene; descriptions, index and
// checksums may be absent. Throws std::invalid_argument naming the file, and line and column where there is
// one, for whatever is not well-formed.
FolderVerdict check_folder(const std::filesystem::path& folder, std::size_t every, const TellProgress& tell);

}  // namespace fde
