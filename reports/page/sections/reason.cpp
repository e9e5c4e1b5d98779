// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>
#include <optional>

#include "fdebench/reports/page/facts.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

std::optional<double> observed_rate_of(const PageInput& page, const SceneSettings& scene,
                                       const RecommendedRun& line, Norm norm) {
  for (const RateRow& row : page.rates) {
    if (row.scene != scene || row.scheme != line.schemes.front() || !same_series(row.settings, line.settings))
      continue;
    const NormRate& rate = norm == Norm::end ? row.end : row.maximum;
    if (rate.fit.points > 0) return rate.fit.slope;
  }
  return std::nullopt;
}

}  // namespace

// Time = steps * time per step: the factor that distinguishes the first line from the second.
json reason_for_speed(const PageInput& page, const SceneSettings& scene, const RecommendedRun& first,
                      const RecommendedRun& second, Norm norm) {
  const double fewer = static_cast<double>(second.steps) / first.steps;
  const double dearer = first.seconds_per_step() / second.seconds_per_step();
  json reason{{"line", page.label(second)}};
  if (second.first_run && second.setup_seconds > second.later_run_seconds()) {
    reason["setup"] = fact(second.setup_seconds);
    return reason;
  }
  if (fewer < 1.5) {
    reason["step_seconds"] = {fact(first.seconds_per_step()), fact(second.seconds_per_step())};
    return reason;
  }
  reason["steps"] = {first.steps, second.steps};
  const auto ours = observed_rate_of(page, scene, first, norm),
             theirs = observed_rate_of(page, scene, second, norm);
  if (ours && theirs && *ours > *theirs + 0.2) reason["rates"] = {fact(ours), fact(theirs)};
  if (dearer > 1.5) reason["dearer"] = fact(dearer);
  return reason;
}

}  // namespace fde::bench
