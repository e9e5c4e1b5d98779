// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/placed_run.hpp"

#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

#include "fdebench/benchmarks/records/key_text.hpp"
#include "fdebench/benchmarks/records/record_text.hpp"

namespace fde::bench {

Digest digest_of(const RunKey& run) { return digest_of(json_of(run).dump()); }

Record read_record(const LinesByOffset& file, const PlacedRun& place) {
  auto run = std::get<Record>(parse_line(file.line(place.examination)));
  if (!place.has_own_times) run.timing = {};
  run.session = run.timing.session = place.session;
  if (place.times == 0) return run;
  auto later = std::get<LaterTimes>(parse_line(file.line(place.times))).timing;
  later.session = place.session_of_times;
  later.count = place.later_timings;
  run.take(std::move(later));
  return run;
}

}  // namespace fde::bench
