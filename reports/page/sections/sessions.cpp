// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "fdebench/reports/page/facts.hpp"

namespace fde::bench {

using nlohmann::json;

namespace {

// The times of a session.
struct SessionTimes {
  std::size_t all = 0, disturbed = 0;

  // "3 of 50" if other work disturbed some; otherwise null.
  [[nodiscard]] json text() const {
    return disturbed > 0 ? json(fmt::format("{} of {}", disturbed, all)) : json();
  }
};

std::vector<SessionTimes> times_of_sessions(const PageInput& page) {
  std::vector<SessionTimes> times(page.sessions.size());
  for (const auto* some : {&page.runs.finished, &page.families.finished, &page.trials}) {
    for (const Record& run : *some) {
      if (!run["time_median"]) continue;
      ++times[run.last_session()].all;
      if (run.timing.is_disturbed()) ++times[run.last_session()].disturbed;
    }
  }
  return times;
}

}  // namespace

json session_facts(const PageInput& page) {
  const auto times = times_of_sessions(page);
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
                   {"disturbed times", times[all.size()].text()}});
  }
  return compact(all);
}

}  // namespace fde::bench
