// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "fdebench/reports/page/facts.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

json row(const PageInput& page, const Record& run) {
  json facts = run_facts(
      page, run,
      {"time_minimum", "error_end", "mescd", "states", "start_weights", "rhs_calls", "history_bytes"});
  if (const auto setup = run["time_setup"], seconds = run["time_minimum"]; setup && seconds)
    facts["first_seconds"] = fact(*seconds + (run.timing.first_run ? 0.0 : *setup));
  if (const auto iterations = run["newton_iterations"]) {
    facts["newton"] = {{"iterations", fact(iterations)},
                       {"tolerance", fact(run.key.settings.newton_tolerance)}};
  } else {
    facts["explicit"] = !run.key.external;
  }
  return facts;
}

}  // namespace

json cost_section(const PageInput& page) {
  json groups = json::array();
  for (const RunSpan scene : by_scene(page.runs.finished)) {
    json rows = json::array();
    for (const RunSpan line : by_line(scene)) rows.push_back(row(page, line.back()));
    groups.push_back({{"title", name_of_scene(page, scene.front().key.scene).title}, {"rows", rows}});
  }
  return {{"id", "cost"}, {"groups", groups}};
}

}  // namespace fde::bench
