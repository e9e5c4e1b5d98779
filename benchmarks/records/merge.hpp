#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "scenes/registry.hpp"

namespace fde {

// What a merge has taken.
struct Merged {
  std::size_t sessions = 0, rows = 0, repeated_rows = 0;  // repeated ones are not taken
};

// Writes a results file of all that these hold: sessions in the order in which they first stand there, each
// once, with the rows of every file that has it. What was measured once and stands in several files is taken
// once. No file is held in memory. Throws std::invalid_argument where `out` exists or a file is no results
// file, as scan_results says, and std::system_error where `out` cannot be written; then there is none.
Merged merge_results(const std::vector<std::filesystem::path>& files, const std::filesystem::path& out,
                     const Scenes& known = scenes());

}  // namespace fde
