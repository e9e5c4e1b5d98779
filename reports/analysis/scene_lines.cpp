// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/scene_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "fdebench/benchmarks/records/counted_error.hpp"
#include "fdebench/benchmarks/search/refinement.hpp"
#include "fdebench/benchmarks/text/output_text.hpp"

namespace fde::bench {
namespace {

// nullopt if the run has no error of this kind.
std::optional<RecommendedRun> option_of(const Record& run, const ErrorKind& kind) {
  const auto error = counted_error(run, kind);
  if (!error) return std::nullopt;
  RecommendedRun option{.schemes = {run.key.scheme},
                        .settings = run.key.settings,
                        .steps = run.steps,
                        .error = error->value,
                        .session = run.last_session(),
                        .external = run.key.external,
                        .wall_clock = run.timing.wall_clock};
  option.time = time_of(run).value_or(MedianInterval{});
  option.setup_seconds = run["time_setup"].value_or(0.0);
  option.first_run = run.timing.first_run;
  return option;
}

bool is_timed(const RecommendedRun& option) { return option.time.median > 0.0; }

bool is_quicker(const RecommendedRun& a, const RecommendedRun& b) {
  return std::tie(a.time.median, a.error) < std::tie(b.time.median, b.error);
}

// Whether the run is within the accuracy and better than the baseline, whose error is recorded only if it is
// not.
bool is_within(const Record& run, const ErrorKind& kind, double accuracy) {
  const auto error = counted_error(run, kind);
  return error && error->is_within(accuracy) && !run[baseline_measure(kind)];
}

// The errors with fewer than `below` steps; empty with adaptive step size, which has no rate.
std::vector<TrialError> errors_of(RunSpan line, const ErrorKind& kind, int below) {
  std::vector<TrialError> errors;
  for (const Record& run : line) {
    if (!std::holds_alternative<int>(run.key.settings.resolution)) continue;
    const auto error = run[error_measure(kind)];
    if (error && run.steps > 0 && run.steps < below) errors.push_back({run.steps, *error});
  }
  return errors;
}

std::optional<RecommendedRun> quickest_within(RunSpan line, const ErrorKind& kind, double accuracy) {
  std::optional<RecommendedRun> best;
  for (const Record& run : line) {
    if (!is_within(run, kind, accuracy)) continue;
    const auto option = option_of(run, kind);
    if (!is_timed(*option)) continue;
    if (!best || is_quicker(*option, *best)) best = option;
  }
  return best;
}

// The runs of a line as the search sees them, to ask whether two lines are one algorithm.
Refinement refinement_of(RunSpan line) {
  Refinement refinement;
  for (const Record& run : line) {
    refinement.is_adaptive = !std::holds_alternative<int>(run.key.settings.resolution);
    RefinementRun seen{.resolution = run.steps, .steps = run.steps};
    for (const auto* error : {"error_end", "error_maximum"})
      seen.errors.push_back({.value = run[error].value_or(INFINITY)});
    refinement.runs.push_back(std::move(seen));
  }
  return refinement;
}

bool is_one_algorithm(RunSpan a, RunSpan b) {
  return same_series(a.front().key.settings, b.front().key.settings) &&
         is_same_algorithm(refinement_of(a), refinement_of(b));
}

std::vector<NamedLine> named_lines(RunSpan runs) {
  std::vector<NamedLine> lines;
  for (const RunSpan line : by_line(runs)) {
    const auto& name = line.front().key.scheme;
    const auto first = std::ranges::find_if(
        lines, [&](const NamedLine& other) { return is_one_algorithm(other.runs, line); });
    if (first == lines.end()) {
      lines.push_back({line, {name}});
    } else if (line.size() > first->runs.size()) {
      first->runs = line;
      first->names.insert(first->names.begin(), name);
    } else {
      first->names.push_back(name);
    }
  }
  return lines;
}

std::size_t count_untimed(RunSpan runs, const ErrorKind& kind, double accuracy) {
  return static_cast<std::size_t>(std::ranges::count_if(runs, [&](const Record& run) {
    return is_within(run, kind, accuracy) && !is_timed(*option_of(run, kind));
  }));
}

}  // namespace

SceneLines::SceneLines(const Runs& runs, const SceneSettings& scene)
    : SceneLines(of_scene(runs.finished, scene)) {}

SceneLines::SceneLines(RunSpan scene) : runs_(scene), lines_(named_lines(runs_)) {}

std::vector<RecommendedRun> SceneLines::within(const ErrorKind& kind, double accuracy) const {
  std::vector<RecommendedRun> ranked;
  for (const auto& [line, names] : lines_) {
    auto best = quickest_within(line, kind, accuracy);
    if (!best) continue;
    best->schemes = names;
    ranked.push_back(std::move(*best));
  }
  std::ranges::stable_sort(ranked, is_quicker);
  return ranked;
}

RecommendedRun with_prediction(RecommendedRun option, const Runs& runs, const SceneSettings& scene,
                               const ErrorKind& kind) {
  for (const RunSpan line : by_line(of_scene(runs.finished, scene))) {
    const RunKey& key = line.front().key;
    if (key.scheme != option.schemes.front() || !same_series(key.settings, option.settings)) continue;
    option.rate = observed_rate(errors_of(line, kind, option.steps + 1));
    const ErrorModel model(errors_of(line, kind, option.steps));
    if (!model.empty()) option.predicted_error = model.error(option.steps).value;
  }
  return option;
}

std::vector<ErrorForecast> SceneLines::forecasts(const ErrorKind& kind) const {
  std::vector<ErrorForecast> all;
  for (const auto& [line, names] : lines_) {
    const Record& finest = line.back();
    ErrorModel errors(errors_of(line, kind, finest.steps + 1));
    if (errors.empty()) continue;
    all.push_back({finest.steps,
                   option_of(finest, kind).value_or(RecommendedRun{.schemes = {finest.key.scheme}}),
                   std::move(errors)});
  }
  return all;
}

std::optional<Shortfall> SceneLines::shortfall(const ErrorKind& kind, double accuracy,
                                               std::span<const ErrorForecast> forecasts) const {
  constexpr double part_of_rounding = 0.25, part_of_reference = 0.1;
  const auto error_of = [&](const Record& run) {
    return counted_error(run, kind).value_or(CountedError{INFINITY, 0.0});
  };
  const auto best =
      std::ranges::min_element(runs_, {}, [&](const Record& run) { return error_of(run).value; });
  if (best == runs_.end() || !counted_error(*best, kind)) return std::nullopt;
  const CountedError error = error_of(*best);
  Shortfall found{.best = *option_of(*best, kind), .untimed = count_untimed(runs_, kind, accuracy)};
  found.is_no_better = found.untimed == 0 && error.is_within(accuracy);
  found.is_rounding =
      error.value > accuracy && (*best)["rounding"].value_or(0.0) >= part_of_rounding * error.value;
  if (!found.is_rounding && error.reference_bound >= part_of_reference * error.value)
    found.known_up_to = error.reference_bound;
  if (error.reference_bound >= accuracy) return found;
  const auto fewest = std::ranges::min_element(forecasts, {}, [&](const ErrorForecast& of) {
    return std::max(of.errors.likely_steps(accuracy), of.finest + 1.0);
  });
  if (fewest != forecasts.end()) {
    found.steps_needed = steps_beyond(fewest->finest, fewest->errors.steps(accuracy));
    found.line = fewest->line;
  }
  return found;
}

}  // namespace fde::bench
