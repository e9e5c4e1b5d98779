// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "fdebench/reports/analysis/line_names.hpp"
#include "fdebench/reports/analysis/recommendation.hpp"
#include "fdebench/reports/analysis/text.hpp"

namespace fde::bench {
namespace {

constexpr double most_steps_shown = 2e9, most_seconds_shown = 1e4;

RunSettings setup_of(const Configuration& configuration, const StepsOrTolerance& resolution) {
  return {.resolution = resolution, .grading = configuration.grading};
}

RecommendedRun option_of(const SearchCandidate& of) {
  RecommendedRun option{
      .schemes = of.names,
      .setup = setup_of(of.configuration, resolution_of(of.best)),
      .steps = of.best.steps,
      .error = of.best.error,
      .time = of.time.value_or(MedianInterval{of.best.seconds, of.best.seconds, of.best.seconds}),
      .setup_seconds = of.setup_seconds,
      .rate = of.rate};
  if (of.predicted) option.predicted_error = of.predicted->value;
  return option;
}

std::string name_of(const SearchCandidate& of) {
  return name_of(RecommendedRun{.schemes = of.names, .setup = setup_of(of.configuration, 1)});
}

// The finest run with a finite error; nullptr if there is none.
const CandidateRun* finest(const SearchCandidate& of) {
  const auto found = std::find_if(of.refinements.rbegin(), of.refinements.rend(),
                                  [](const CandidateRun& attempt) { return std::isfinite(attempt.error); });
  return found == of.refinements.rend() ? nullptr : &*found;
}

std::string so_far(const SearchCandidate& of, std::string_view error) {
  if (const auto* attempt = finest(of)) {
    const auto* worse = attempt->error < attempt->baseline_error ? "" : "worse than y = 0, ";
    return fmt::format("{}{} {} with N = {}", worse, error, error_text(attempt->error),
                       count_text(attempt->steps));
  }
  return of.refinements.empty() ? "no run" : sentence(of.refinements.back().ending);
}

// The outcome of a configuration that gives no option, as text.
std::string fate(const SearchCandidate& of, std::string_view error) {
  switch (of.outcome) {
    case SearchOutcome::stagnated:
      return fmt::format("{}: its {} falls no more: {}", name_of(of), error, so_far(of, error));
    case SearchOutcome::refused:
      return fmt::format("{}: refused: {}", name_of(of), of.reason);
    case SearchOutcome::failed:
      return fmt::format("{}: {}", name_of(of), of.reason);
    default:
      return fmt::format("{}: {}{}{}", name_of(of), of.outcome == SearchOutcome::slower ? "slower: " : "",
                         so_far(of, error),
                         of.steps_needed ? "; " + needed_text("it", *of.steps_needed) : "");
  }
}

// The predicted run within the accuracy; nullopt if there is no prediction or it needs too many steps or
// seconds.
std::optional<RecommendedRun> expected_of(const SearchCandidate& of, double accuracy) {
  if (!of.steps_needed || of.steps_needed->value > most_steps_shown ||
      of.steps_needed->high * of.seconds_per_step > most_seconds_shown)
    return std::nullopt;
  const auto& steps = *of.steps_needed;
  return RecommendedRun{.schemes = of.names,
                        .setup = setup_of(of.configuration, 1),
                        .steps = static_cast<int>(steps.value),
                        .error = accuracy,
                        .time = {steps.value * of.seconds_per_step, steps.low * of.seconds_per_step,
                                 steps.high * of.seconds_per_step},
                        .rate = of.rate};
}

bool is_shown(const Recommendation& made, const SearchCandidate& of) {
  const auto same = [&](const RecommendedRun& option) { return option.schemes.front() == of.names.front(); };
  return std::ranges::any_of(made.options, same) || std::ranges::any_of(made.expected, same);
}

// Adds to made.expected the best prediction of each scheme that gives no option, and to made.others the
// outcome of each scheme without a prediction.
void tell_others(const std::vector<SearchCandidate>& searched, Recommendation& made) {
  std::vector<RecommendedRun> expected;
  for (const SearchCandidate& of : searched) {
    if (auto option = expected_of(of, made.accuracy)) expected.push_back(std::move(*option));
  }
  std::ranges::stable_sort(expected, {}, [](const RecommendedRun& option) { return option.time.median; });
  for (RecommendedRun& option : expected) {
    const auto same = [&](const RecommendedRun& other) { return other.schemes == option.schemes; };
    if (std::ranges::none_of(made.options, same) && std::ranges::none_of(made.expected, same))
      made.expected.push_back(std::move(option));
  }
  for (const SearchCandidate& of : searched) {
    if (of.outcome != SearchOutcome::duplicate && of.configuration.grading == 1.0 && !is_shown(made, of))
      made.others.push_back(fate(of, error_word(made)));
  }
}

// Without options: adds to made.others the smallest error, and the prediction that takes the least time.
void tell_shortfall(const std::vector<SearchCandidate>& searched, const std::vector<std::string>& columns,
                    Recommendation& made) {
  const SearchCandidate* best = nullptr;
  for (const SearchCandidate& of : searched) {
    const auto* attempt = finest(of);
    if (attempt != nullptr && (best == nullptr || attempt->error < finest(*best)->error)) best = &of;
  }
  if (best == nullptr) return tell_others(searched, made);
  const CandidateRun& last = *finest(*best);
  made.others.push_back(fmt::format("best: {}: {}, in {} at t = {:.6g}", name_of(*best),
                                    so_far(*best, error_word(made)),
                                    columns[static_cast<std::size_t>(last.column)], last.time));
  const SearchCandidate* least = nullptr;
  const auto seconds = [](const SearchCandidate& of) { return of.steps_needed->value * of.seconds_per_step; };
  for (const SearchCandidate& of : searched) {
    if (of.steps_needed && (least == nullptr || seconds(of) < seconds(*least))) least = &of;
  }
  if (least == nullptr) return;
  made.others.push_back(needed_text(name_of(*least), *least->steps_needed) +
                        fmt::format(", {}", time_text(seconds(*least))));
}

}  // namespace

Recommendation recommend(const std::vector<SearchCandidate>& searched, const SceneSettings& scene,
                         const std::vector<std::string>& columns, const AccuracyTarget& question,
                         const std::optional<ErrorEstimate>& estimate) {
  Recommendation made{
      .scene = scene, .kind = question.kind, .accuracy = question.accuracy, .estimate = estimate};
  for (const SearchCandidate& of : searched) {
    if (of.outcome != SearchOutcome::accuracy_reached) continue;
    made.options.push_back(option_of(of));
    made.constant = std::isinf(of.best.baseline_error);
  }
  made.options.empty() ? tell_shortfall(searched, columns, made) : tell_others(searched, made);
  return made;
}

Recommendation recommend(const Runs& runs, const SceneSettings& scene, const ErrorKind& kind,
                         double accuracy) {
  const LineNames names(runs);
  const SceneLines lines(runs, scene);
  Recommendation made{
      .scene = scene, .kind = kind, .accuracy = accuracy, .options = lines.within(kind, accuracy)};
  for (RecommendedRun& option : made.options) option = with_prediction(std::move(option), runs, scene, kind);
  if (!made.options.empty()) return made;
  const auto missed = lines.shortfall(kind, accuracy, lines.forecasts(kind));
  if (!missed) {
    made.others.push_back(fmt::format("no finished run has {}", error_measure(kind)));
    return made;
  }
  const auto name = [&](const RecommendedRun& of) { return names.name(of.schemes.front(), of.setup); };
  made.others.push_back(fmt::format("best: {}: {}", name(missed->best), run_text(missed->best)));
  if (missed->untimed > 0) {
    made.others.push_back(
        fmt::format("{} runs within it are not timed yet: continue the sweep", missed->untimed));
  }
  if (missed->steps_needed) made.others.push_back(needed_text(name(missed->line), *missed->steps_needed));
  return made;
}

}  // namespace fde::bench
