// SPDX-License-Identifier: MIT
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "fdebench/benchmarks/records/default_accuracies.hpp"
#include "fdebench/reports/page/facts.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

// Consecutive accuracies with the same cheapest line.
struct AccuracyRange {
  RecommendedRun first, last;
  double from = 0.0, to = 0.0;
};

std::vector<AccuracyRange> ranges_of(const PageInput& page, const SceneLines& lines, const ErrorKind& kind) {
  std::vector<AccuracyRange> found;
  for (const double accuracy : default_accuracies) {
    const auto ranked = lines.within(kind, accuracy);
    if (ranked.empty()) break;
    if (!found.empty() && page.label(found.back().last) == page.label(ranked.front())) {
      found.back().last = ranked.front();
      found.back().to = accuracy;
    } else {
      found.push_back({ranked.front(), ranked.front(), accuracy, accuracy});
    }
  }
  return found;
}

json range_facts(const PageInput& page, const AccuracyRange& of) {
  return {{"line", page.label(of.first)},
          {"from", of.from == of.to ? json() : json(of.from)},
          {"to", of.to},
          {"seconds", {fact(of.first.time.median), fact(of.last.time.median)}}};
}

// The cheapest line at the smallest accuracy that any reaches, and why it is the first.
json leader(const PageInput& page, const SceneSettings& scene, const SceneLines& lines, const ErrorKind& kind,
            double accuracy) {
  const auto ranked = lines.within(kind, accuracy);
  json facts{{"line", page.label(ranked.front())}, {"accuracy", accuracy}};
  if (ranked.size() > 1) facts["second"] = reason_for_speed(page, scene, ranked[0], ranked[1], kind.norm);
  return facts;
}

// Why no run is within this accuracy, the first that none reaches: its error is rounding or not resolved by
// the reference.
json limit(const PageInput& page, const SceneLines& lines, const ErrorKind& kind, double accuracy) {
  const auto missed = lines.shortfall(kind, accuracy, {});
  if (!missed || missed->untimed > 0) return {};
  json facts{{"accuracy", accuracy}, {"error", fact(missed->best.error)}, {"line", page.label(missed->best)}};
  facts["is_rounding"] = missed->is_rounding;
  facts["is_unresolved"] = missed->known_up_to.has_value();
  return facts;
}

}  // namespace

json conclusion(const PageInput& page, const SceneLines& lines, RunSpan runs, const ErrorKind& kind) {
  const SceneSettings& scene = runs.front().key.scene;
  json facts = json::object();
  double reached = 1.0;
  if (const auto found = ranges_of(page, lines, kind); !found.empty()) {
    reached = found.back().to;
    for (const AccuracyRange& range : found) facts["cheapest"].push_back(range_facts(page, range));
    facts["leader"] = leader(page, scene, lines, kind, reached);
  }
  const auto* const next =
      std::ranges::find_if(default_accuracies, [&](double accuracy) { return accuracy < 0.5 * reached; });
  if (next != default_accuracies.end()) facts["limit"] = limit(page, lines, kind, *next);
  std::set<std::string> refused, ended;
  for (const Record& run : of_scene(page.runs.failed, scene))
    (run.ending.kind == SolveStatus::refused ? refused : ended).insert(page.label(run.key));
  facts["ended"] = ended;
  if (!refused.empty()) facts["refused"] = refused.size();
  return compact(facts);
}

}  // namespace fde::bench
