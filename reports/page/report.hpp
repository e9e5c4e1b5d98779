// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "fdebench/reports/analysis/runs.hpp"

namespace fde::bench {

// Writes <directory>/index.html, a self-contained file: the cheapest runs, charts and tables of each scene,
// refused and failed runs. Creates the directory if necessary and replaces an older page atomically. Returns
// the path. Throws std::invalid_argument naming a path that cannot be written, or if this build has no chart
// scripts. `before`: as in page_data().
std::filesystem::path write_report(ReadRuns read, const std::filesystem::path& directory,
                                   const std::optional<ReadRuns>& before = {});

}  // namespace fde::bench
