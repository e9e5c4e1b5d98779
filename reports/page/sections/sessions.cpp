// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "fdebench/reports/page/facts.hpp"

namespace fde::bench {

using nlohmann::json;

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
                   {"version", of.version}});
  }
  return compact(all);
}

}  // namespace fde::bench
