// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace fde::bench {

struct FlatTable {
  std::string csv{};
  std::size_t rows = 0;
  std::string warning{};  // of lines that are left out
};

// The runs of a results file, of each the last examination, as one table with a row a run: its scene, a
// column for each parameter that some scene has set, its settings, how it ended, and a column for each
// quantity that some run has. Throws as read_results does.
FlatTable flat_table(const std::filesystem::path& file);

}  // namespace fde::bench
