// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace fde::bench {

// The counts of a merge.
struct MergeCounts {
  std::size_t sessions = 0, rows = 0, repeated_rows = 0;  // repeated_rows: not copied
  std::vector<std::string> warnings{};                    // of lines that are left out, one a file
};

// Writes a results file with the contents of all files: each session once, in the order of first occurrence,
// with the lines of every file that has it, identical ones once. Throws std::invalid_argument if `out` exists
// or a file is not a results file, as ResultsReader says, and std::system_error if `out` cannot be written;
// `out` is then not created.
MergeCounts merge_results(const std::vector<std::filesystem::path>& files, const std::filesystem::path& out);

}  // namespace fde::bench
