#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "page/page_data.hpp"

namespace fde {

// Runs as columns of equal length, a name once and not in each run: `lines` the labels, `line` which of them
// a run has, `steps`, `h` (or `end`, where h is end / steps of all), `asked` of runs that were asked for an
// accuracy, the quantities of the records that charts and their tooltips show, to five digits; null where a
// run has none, without a column that would be empty. `session` where there are several, `wall_clock` where
// times are of whole processes.
nlohmann::json run_columns(const PageInput& page, const std::vector<const MeasuredRun*>& runs);

}  // namespace fde
