// SPDX-License-Identifier: MIT
#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "fdebench/benchmarks/records/default_accuracies.hpp"
#include "fdebench/reports/page/facts.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

// The smallest error of other algorithms than the first; null if there are none.
json next_best(const PageInput& page, const SceneSettings& scene, const RecommendedRun& first,
               const ErrorKind& kind) {
  const Record* next = nullptr;
  const auto measure = error_measure(kind);
  for (const Record& run : of_scene(page.runs.finished, scene)) {
    if (!run[measure] || std::ranges::count(first.schemes, run.key.scheme) > 0) continue;
    if (next == nullptr || *run[measure] < *(*next)[measure]) next = &run;
  }
  if (next == nullptr) return {};
  return {{"line", page.label(next->key)}, {"error", fact((*next)[measure])}};
}

// The lines whose time interval overlaps the first's.
std::vector<std::string> ties(const PageInput& page, std::span<const RecommendedRun> ranked) {
  std::vector<std::string> lines;
  for (const RecommendedRun& other : ranked.subspan(1)) {
    if (other.time.low <= ranked.front().time.high) lines.push_back(page.label(other));
  }
  return lines;
}

// The run, and how `fdebench solve` repeats it.
json repeatable(const PageInput& page, const RecommendedRun& run) {
  json facts = run_facts(page, run);
  facts["scheme"] = run.schemes.front();
  facts["options"] = options_of(run);
  return facts;
}

// The quickest run, and the distance of the other lines from it.
json winner(const PageInput& page, const SceneSettings& scene, std::span<const RecommendedRun> ranked,
            const ErrorKind& kind) {
  const RecommendedRun& first = ranked.front();
  json row = repeatable(page, first);
  row["same"] = std::vector(first.schemes.begin() + 1, first.schemes.end());
  row["ties"] = ties(page, ranked);
  if (ranked.size() == 1) {
    row["next_best"] = next_best(page, scene, first, kind);
    return row;
  }
  row["second"] = reason_for_speed(page, scene, first, ranked[1], kind.norm);
  row["second"]["ratio"] = fact(ranked[1].time.median / first.time.median);
  return row;
}

// The best that there is if no run is within the accuracy, and why that is no better.
json shortfall(const PageInput& page, const Shortfall& missed) {
  json row{{"best", repeatable(page, missed.best)},
           {"untimed", missed.untimed > 0},
           {"is_no_better", missed.is_no_better},
           {"is_rounding", missed.is_rounding},
           {"known_up_to", fact(missed.known_up_to)}};
  if (const auto& needed = missed.steps_needed) {
    const double seconds = needed->value * missed.line.seconds_per_step();
    row["needed"] = {{"line", page.label(missed.line)},
                     {"seconds", seconds > 0.0 ? fact(seconds) : json()},
                     {"steps", fact(needed->value)},
                     {"low", fact(needed->low)},
                     {"high", fact(needed->high)}};
  }
  return row;
}

json answer(const PageInput& page, const SceneSettings& scene, const SceneLines& lines, const ErrorKind& kind,
            std::span<const ErrorForecast> forecasts, double accuracy) {
  if (const auto ranked = lines.within(kind, accuracy); !ranked.empty())
    return winner(page, scene, ranked, kind);
  const auto missed = lines.shortfall(kind, accuracy, forecasts);
  return missed ? shortfall(page, *missed) : json::object();
}

}  // namespace

json answers_section(const PageInput& page) {
  if (page.runs.finished.empty() && page.families.finished.empty()) return {};
  const auto& runs = page.runs.finished.empty() ? page.families.finished : page.runs.finished;
  return compact({{"id", "answer"},
                  {"accuracies", default_accuracies},
                  {"several_sessions", page.sessions.size() > 1},
                  {"first_run", runs.front().timing.first_run},
                  {"schemes", scheme_verdicts(page)}});
}

json scene_answers(const PageInput& page, const SceneSettings& scene, const SceneLines& lines,
                   const ErrorKind& kind) {
  json rows = json::array();
  const auto forecasts = lines.forecasts(kind);
  for (const double accuracy : default_accuracies) {
    json row = answer(page, scene, lines, kind, forecasts, accuracy);
    row["accuracy"] = accuracy;
    rows.push_back(std::move(row));
  }
  return compact(rows);
}

}  // namespace fde::bench
