// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "fdebench/reports/page/page_data.hpp"

namespace fde::bench {

// Runs as JSON columns of equal length: `lines` (the labels), `line` (index of a run's label), `steps`, `h`
// (or the number `end` if h = end / steps for all runs), `requested` (tolerance, with adaptive step size),
// and the quantities that charts and tooltips show, to five digits or less. null where a run has no value;
// columns of nulls are left out. `session` if there are several, `wall_clock` if times are of whole
// processes.
nlohmann::json run_columns(const PageInput& page, const std::vector<const Record*>& runs);

}  // namespace fde::bench
