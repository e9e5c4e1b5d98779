#pragma once

#include <filesystem>
#include <optional>

#include "analysis/runs.hpp"

namespace fde {

// Writes <directory>/index.html, one file that needs no network: the answer, the charts and tables of each
// scene, and what was refused or failed. Makes the directory where it is missing; a reader of an older page
// never sees half a page. Returns the path. Throws std::invalid_argument naming the path that cannot be
// written, or where the charts' scripts were missing when this was built. before: as in page_data.
std::filesystem::path write_report(ReadRuns read, const std::filesystem::path& directory,
                                   const std::optional<ReadRuns>& before = {});

}  // namespace fde
