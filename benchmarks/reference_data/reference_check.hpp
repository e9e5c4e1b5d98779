// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "fdebench/benchmarks/reference_data/reference_folder.hpp"
#include "fdebench/benchmarks/reference_data/table_comparison.hpp"

namespace fde::bench {

// The result of a check of one table.
struct TableCheck {
  std::string table{};  // file name in the folder
  std::size_t rows = 0, recomputed = 0, wrong = 0;
  std::size_t worst_line = 0;  // line in the file of the row with the largest ratio
  std::string worst_row{};     // cells of that row
  RowComparison worst{};       // comparison of that row
  bool described = false;      // has a JSON description; without it scene and parameters are assumed
  std::vector<std::string> assumptions{};  // missing information, and the assumption made instead
};

struct FolderCheck {
  std::vector<TableCheck> tables{};
  std::set<std::string> changed{};  // files that differ from a given checksum
};

// Recomputes every `every`-th row of every table (.csv) in a folder, starting with the first. The folder may
// come from another program: the kind of a table follows from its columns, its scene from the description or
// the file name; descriptions, index and checksums are optional. `progress` is called after each table, by
// one thread at a time. Throws std::invalid_argument naming the file, with line and column where applicable,
// for a malformed file.
FolderCheck check_folder(const std::filesystem::path& folder, std::size_t every,
                         const TableProgress& progress);

}  // namespace fde::bench
