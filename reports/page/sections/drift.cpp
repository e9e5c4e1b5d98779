// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fdebench/reports/analysis/formulations.hpp"
#include "fdebench/reports/analysis/text.hpp"
#include "fdebench/reports/page/page_data.hpp"

namespace fde::bench {
namespace {

constexpr auto internal = "internal drift", independent = "independent drift";
constexpr double least_correlation = 0.95;

Cell size(const MeasuredRun& run, std::string_view quantity) {
  const auto drift = run[quantity];
  return {.text = drift ? error_text(*drift) : ""};
}

Cell growth(const MeasuredRun& run, std::string_view quantity) {
  const auto power = run[quantity];
  return {.text = power ? fmt::format("{:.2f}", *power) : ""};
}

Cell rate(RunSpan line, std::string_view quantity) {
  const Fit fit = observed_rate(line, quantity);
  if (fit.points == 0 || fit.correlation < least_correlation) return {};
  return {.text = fmt::format("{:.2f}", fit.slope),
          .detail = fmt::format("correlation {:.4f}", fit.correlation)};
}

std::vector<Cell> row(const PageInput& page, const std::string& formulation, RunSpan line, int steps) {
  const auto found = std::ranges::find(line, steps, &MeasuredRun::steps);
  const auto until = found == line.end() ? line.end() : std::next(found);
  const RunSpan fitted(line.begin(), until);
  const MeasuredRun& run = fitted.back();
  const std::string label = page.label(run.key);
  const auto error = run["error_end"], seconds = run["time_minimum"];
  return {{.text = formulation},
          {.text = label, .line = label},
          {.text = count_text(run.steps)},
          size(run, "drift_internal"),
          growth(run, "drift_internal_growth"),
          rate(fitted, "drift_internal"),
          size(run, "drift_independent"),
          growth(run, "drift_independent_growth"),
          rate(fitted, "drift_independent"),
          {.text = error ? error_text(*error) : ""},
          {.text = seconds ? time_text(*seconds) : ""}};
}

std::string with_run(const PageInput& page, const BestInTime& best) {
  const auto error = best.run["error_end"];
  return fmt::format("{} with {} ({}{} at N = {})", best.formulation, page.label(best.run.key),
                     error_text(effective_drift(best.run)), error ? ", error " + error_text(*error) : "",
                     count_text(best.run.steps));
}

// A text: which formulation has the least drift in the same time; empty with one formulation or without
// times.
std::string advice(const PageInput& page, const ConstrainedScene& scene) {
  const auto [seconds, ranked] = best_in_time(scene);
  if (ranked.size() < 2) return {};
  std::vector<std::string> others;
  for (std::size_t i = 1; i < ranked.size(); ++i) others.push_back(with_run(page, ranked[i]));
  return fmt::format("{}: within {}, the constraint is kept best by {}; then {}.",
                     name_of_scene(scene.scene).title, time_text(seconds), with_run(page, ranked.front()),
                     fmt::join(others, ", "));
}

bool at_rounding(const FormulationRuns& of) {
  return std::ranges::all_of(of.runs, [](const auto& run) {
    const bool diverged = run["error_end"].value_or(0.0) > 1.0;
    return diverged || *run["drift_internal"] <= rounding_drift;
  });
}

// The formulations whose runs all keep the constraint to rounding, on every scene; empty if there are none.
std::string on_rounding(const std::vector<ConstrainedScene>& scenes) {
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
  if (names.empty()) return {};
  return fmt::format(
      "With the scheme's own memory every run of these that did not diverge keeps the constraint to rounding "
      "(1e-12): {}.",
      fmt::join(names, ", "));
}

}  // namespace

Section drift_section(const PageInput& page) {
  Section section{
      .id = "drift",
      .title = "Drift from the constraints",
      .paragraphs =
          {"The largest |f(t, q, v, w)| along the computed path, in the unit of f. The internal drift "
           "takes the scheme's own w at every step; the independent one takes the derivative of fractional "
           "order of the computed path, by a rule of higher order than any scheme here. Growth is p where "
           "the largest drift so far grows like t^p, 0 where it stays bounded. The rate in h is fitted "
           "over five step counts at most; it is left out below a correlation of 0.95. No growth or rate "
           "where the drift is at rounding. The table is for the finest step count that the lines of a "
           "scene share. The sentences compare, within the largest time that every formulation was given, "
           "each one's run with the least drift, and of those at rounding the one with the least error."},
      .table = {.caption = "Drift from the constraints by scene, formulation and scheme",
                .columns = {{"formulation"},
                            {"scheme"},
                            {"N"},
                            {"largest", internal},
                            {"growth", internal},
                            {"rate in h", internal},
                            {"largest", independent},
                            {"growth", independent},
                            {"rate in h", independent},
                            {"error at the end"},
                            {"time"}}}};
  const auto scenes = constrained_scenes(page.runs);
  for (const auto& scene : scenes) {
    RowGroup group{.title = name_of_scene(scene.scene).title};
    for (const auto& of : scene.formulations) {
      for (const RunSpan line : by_line(of.runs))
        group.rows.push_back(row(page, of.formulation, line, scene.steps));
    }
    section.table.groups.push_back(std::move(group));
    if (auto text = advice(page, scene); !text.empty()) section.paragraphs.push_back(std::move(text));
  }
  if (auto text = on_rounding(scenes); !text.empty()) section.paragraphs.push_back(std::move(text));
  return section;
}

}  // namespace fde::bench
