// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstddef>
#include <nlohmann/json.hpp>

#include "fdebench/reports/page/facts.hpp"

namespace fde::bench {

using nlohmann::json;

namespace {

// "3 of 50": how many of the session's times other work disturbed; null if none.
json disturbed_times(const PageInput& page, std::size_t session) {
  std::size_t timed = 0, disturbed = 0;
  for (const auto* some : {&page.runs.finished, &page.families.finished, &page.trials}) {
    for (const MeasuredRun& run : *some) {
      if (run.session != session || !run["time_median"]) continue;
      ++timed;
      if (run["disturbed"].value_or(0.0) > 0.0) ++disturbed;
    }
  }
  return disturbed > 0 ? json(fmt::format("{} of {}", disturbed, timed)) : json();
}

}  // namespace

json session_facts(const PageInput& page) {
  json all = json::array();
  for (const Session& of : page.sessions) {
    all.push_back({{"date", of.date},
                   {"machine", of.machine},
                   {"cores", of.cores > 0 ? json(of.cores) : json()},
                   {"system", of.system},
                   {"compiler", of.compiler},
                   {"flags", of.flags},
                   {"commit", of.commit},
                   {"version", of.version},
                   {"node", of.node},
                   {"disturbed times", disturbed_times(page, all.size())}});
  }
  return compact(all);
}

}  // namespace fde::bench
