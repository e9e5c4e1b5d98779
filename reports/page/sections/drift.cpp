// SPDX-License-Identifier: MIT
#include <algorithm>
#include <nlohmann/json.hpp>

#include "fdebench/reports/analysis/formulations.hpp"
#include "fdebench/reports/page/facts.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

constexpr double least_correlation = 0.95;

// The largest drift of a run by one rule, the power of t with which it grows, and the rate of the line.
json drift_facts(const Record& run, RunSpan line, const std::string& quantity) {
  json facts{{"largest", fact(run[quantity])}, {"growth", fact(run[quantity + "_growth"])}};
  const Fit fit = observed_rate(line, quantity);
  if (fit.points > 0 && fit.correlation >= least_correlation)
    facts.update({{"rate", fact(fit.slope)}, {"correlation", fact(fit.correlation)}});
  return facts;
}

json row(const PageInput& page, const std::string& formulation, RunSpan line, int steps) {
  const auto found = std::ranges::find(line, steps, &Record::steps);
  const auto until = found == line.end() ? line.end() : std::next(found);
  const RunSpan fitted(line.begin(), until);
  json facts = run_facts(page, fitted.back(), {"error_end", "time_minimum"});
  facts["formulation"] = formulation;
  facts["internal"] = drift_facts(fitted.back(), fitted, "drift_internal");
  facts["independent"] = drift_facts(fitted.back(), fitted, "drift_independent");
  return facts;
}

// The formulations in the order of their least drift in the same time; null with one formulation or without
// times.
json best_of_formulations(const PageInput& page, const ConstrainedScene& scene) {
  const auto [seconds, ranked] = best_in_time(scene);
  if (ranked.size() < 2) return {};
  json others = json::array();
  for (const BestInTime& best : ranked) {
    json facts = run_facts(page, best.run, {"error_end"});
    facts.update({{"formulation", best.formulation}, {"drift", fact(effective_drift(best.run))}});
    others.push_back(std::move(facts));
  }
  json first = std::move(others.front());
  others.erase(others.begin());
  return {{"title", name_of_scene(page, scene.scene).title},
          {"seconds", fact(seconds)},
          {"best", std::move(first)},
          {"others", std::move(others)}};
}

bool at_rounding(const FormulationRuns& of) {
  return std::ranges::all_of(of.runs, [](const auto& run) {
    const bool diverged = run["error_end"].value_or(0.0) > 1.0;
    return diverged || *run["drift_internal"] <= rounding_drift;
  });
}

// The formulations whose runs all keep the constraint to rounding, on every scene.
std::vector<std::string> on_rounding(const std::vector<ConstrainedScene>& scenes) {
  std::vector<std::string> names;
  for (const auto& scene : scenes) {
    for (const auto& of : scene.formulations) {
      const auto everywhere = [&](const ConstrainedScene& other) {
        return std::ranges::all_of(other.formulations, [&](const FormulationRuns& same) {
          return same.formulation != of.formulation || at_rounding(same);
        });
      };
      const bool listed = std::ranges::find(names, of.formulation) != names.end();
      if (!of.formulation.empty() && !listed && std::ranges::all_of(scenes, everywhere))
        names.push_back(of.formulation);
    }
  }
  return names;
}

}  // namespace

json drift_section(const PageInput& page) {
  json groups = json::array(), best = json::array();
  const auto scenes = constrained_scenes(page.runs);
  for (const auto& scene : scenes) {
    json rows = json::array();
    for (const auto& of : scene.formulations) {
      for (const RunSpan line : by_line(of.runs))
        rows.push_back(row(page, of.formulation, line, scene.steps));
    }
    groups.push_back({{"title", name_of_scene(page, scene.scene).title}, {"rows", rows}});
    if (auto facts = best_of_formulations(page, scene); !facts.empty()) best.push_back(std::move(facts));
  }
  return {{"id", "drift"},
          {"best_in_time", best},
          {"at_rounding", on_rounding(scenes)},
          {"rounding", rounding_drift},
          {"groups", groups}};
}

}  // namespace fde::bench
