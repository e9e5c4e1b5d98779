// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <ostream>
#include <string>

namespace fde::bench {

struct FlatCounts {
  std::size_t rows = 0;
  std::string warning{};  // of lines that are left out
};

// Writes the runs of a results file, of each the last examination, as one table with a row a run: its scene,
// a column for each parameter that some scene has set, its settings, how it ended, and a column for each
// quantity that some run has. Throws as index_results does.
FlatCounts write_flat_table(const std::filesystem::path& file, std::ostream& out);

}  // namespace fde::bench
