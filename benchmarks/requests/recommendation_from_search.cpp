// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/recommendation_from_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fdebench/benchmarks/text/output_text.hpp"

namespace fde::bench {
namespace {

constexpr double most_steps_shown = 2e9, most_seconds_shown = 1e4;

// The configuration without a run.
RecommendedRun unmeasured(const SearchCandidate& of) {
  return {.schemes = of.names,
          .settings = {.grading = of.configuration.grading},
          .rate = of.rate,
          .external = find_scheme(of.names.front()) == nullptr};
}

RecommendedRun measured(const SearchCandidate& of, const RefinementRun& run) {
  RecommendedRun made = unmeasured(of);
  made.settings.resolution = run.resolution;
  made.steps = run.steps;
  made.error = run.error().value;
  made.time = {*run.seconds, *run.seconds, *run.seconds};
  made.setup_seconds = run.setup_seconds;
  made.first_run = run.first_run;
  return made;
}

RecommendedRun option_of(const SearchCandidate& of) {
  RecommendedRun option = measured(of, of.best);
  if (of.time) option.time = *of.time;
  if (of.predicted) option.predicted_error = of.predicted->value;
  return option;
}

std::string name_of(const SearchCandidate& of) { return name_of(unmeasured(of)); }

// The finest run with a finite error; nullptr if there is none.
const RefinementRun* finest(const SearchCandidate& of) {
  const RefinementRun* found = nullptr;
  for (const RefinementRun& run : of.refinement.runs) {
    if (std::isfinite(run.error().value) && (found == nullptr || run.steps > found->steps)) found = &run;
  }
  return found;
}

// Why a configuration has no run within the accuracy.
std::string reason_of(const SearchCandidate& of) {
  switch (of.outcome) {
    case SearchOutcome::stagnated:
      return "its error falls no more";
    case SearchOutcome::refused:
      return "refused: " + of.reason;
    case SearchOutcome::failed:
      return of.reason;
    case SearchOutcome::slower:
      return of.reason.empty() ? "slower" : "slower: " + of.reason;
    default:
      return of.steps_needed
                 ? fmt::format("about N = {} by its errors, {}", rough_count_text(of.steps_needed->value),
                               time_text(of.steps_needed->value * of.seconds_per_step))
             : of.reason.empty() ? std::string("the time ran out")
                                 : of.reason;
  }
}

// With the run that shows that the configuration is slower or fails, otherwise the one with the least error.
RejectedScheme rejected(const SearchCandidate& of) {
  const bool explains = of.outcome == SearchOutcome::slower || of.outcome == SearchOutcome::failed;
  const auto* run = explains ? of.refinement.finest() : finest(of);
  const bool is_solved = run != nullptr && run->seconds;
  RejectedScheme scheme{.finest = is_solved ? measured(of, *run) : unmeasured(of),
                        .reason = reason_of(of),
                        .refused = of.outcome == SearchOutcome::refused};
  if (run != nullptr && std::isfinite(run->error().value) && !(run->error().value < run->error().baseline))
    scheme.reason += scheme.reason.empty() ? "no better than y = 0" : ", no better than y = 0";
  return scheme;
}

// The predicted run within the accuracy; nullopt if there is no prediction or it needs too many steps or
// seconds.
std::optional<RecommendedRun> expected_of(const SearchCandidate& of, double accuracy) {
  if (!of.steps_needed || of.steps_needed->value > most_steps_shown ||
      of.steps_needed->high * of.seconds_per_step > most_seconds_shown)
    return std::nullopt;
  const auto& steps = *of.steps_needed;
  const RefinementRun& finest = *of.refinement.finest();
  const auto seconds = [&](double n) { return finest.counted_setup() + n * of.seconds_per_step; };
  RecommendedRun expected = unmeasured(of);
  expected.steps = static_cast<int>(steps.value);
  expected.error = accuracy;
  expected.time = {seconds(steps.value), seconds(steps.low), seconds(steps.high)};
  expected.setup_seconds = finest.setup_seconds;
  expected.first_run = finest.first_run;
  return expected;
}

// Adds to made.expected the best prediction of each scheme that gives no option, and to made.rejected the
// configurations without one, of each scheme that with the least error first.
void tell_others(const std::vector<SearchCandidate>& searched, Recommendation& made) {
  std::vector<RecommendedRun> expected;
  for (const SearchCandidate& of : searched) {
    if (auto option = expected_of(of, made.accuracy)) expected.push_back(std::move(*option));
    const bool rejects =
        of.outcome != SearchOutcome::duplicate && of.outcome != SearchOutcome::accuracy_reached;
    if (rejects) made.rejected.push_back(rejected(of));
  }
  std::ranges::stable_sort(made.rejected, {}, [](const RejectedScheme& scheme) {
    return scheme.finest.steps > 0 ? scheme.finest.error : std::numeric_limits<double>::infinity();
  });
  std::ranges::stable_sort(expected, {}, [](const RecommendedRun& option) { return option.time.median; });
  for (RecommendedRun& option : expected) {
    const auto same = [&](const RecommendedRun& other) { return other.schemes == option.schemes; };
    if (std::ranges::none_of(made.options, same) && std::ranges::none_of(made.expected, same))
      made.expected.push_back(std::move(option));
  }
}

// Without options: adds to made.missing the smallest error, and the prediction that takes the least time.
void tell_shortfall(const std::vector<SearchCandidate>& searched, const std::vector<std::string>& columns,
                    Recommendation& made) {
  const SearchCandidate* best = nullptr;
  for (const SearchCandidate& of : searched) {
    const auto* attempt = finest(of);
    if (attempt != nullptr && (best == nullptr || attempt->error().value < finest(*best)->error().value))
      best = &of;
  }
  if (best == nullptr) {
    for (const SearchCandidate& of : searched) {
      if (of.configuration.grading == 1.0 && of.outcome != SearchOutcome::duplicate)
        made.missing.push_back(fmt::format("{}: {}", name_of(of), reason_of(of)));
    }
    return;
  }
  const RefinementRun& run = *finest(*best);
  const RunError& last = run.error();
  const auto* useless = last.value < last.baseline ? "" : ", no better than y = 0";
  made.missing.push_back(fmt::format("best: {}: {} {} with N = {}{}, in {} at t = {:.6g}", name_of(*best),
                                     error_word(made), error_text(last.value), count_text(run.steps), useless,
                                     columns[static_cast<std::size_t>(last.column)], last.time));
  const auto is_late = [](const SearchCandidate& of) { return of.outcome == SearchOutcome::out_of_time; };
  if (std::ranges::any_of(searched, is_late)) made.missing.emplace_back("the time of the search ran out");
  const SearchCandidate* least = nullptr;
  const auto seconds = [](const SearchCandidate& of) { return of.steps_needed->value * of.seconds_per_step; };
  for (const SearchCandidate& of : searched) {
    if (of.steps_needed && (least == nullptr || seconds(of) < seconds(*least))) least = &of;
  }
  if (least == nullptr) return;
  made.missing.push_back(needed_text(name_of(*least), *least->steps_needed) +
                         fmt::format(", {}", time_text(seconds(*least))));
}

}  // namespace

Recommendation recommend(const std::vector<SearchCandidate>& searched, const SceneSettings& scene,
                         const std::vector<std::string>& columns, const AccuracyTarget& target,
                         const std::optional<ErrorEstimate>& estimate) {
  Recommendation made{.scene = scene, .kind = target.kind, .accuracy = target.accuracy, .estimate = estimate};
  for (const SearchCandidate& of : searched) {
    if (of.outcome != SearchOutcome::accuracy_reached) continue;
    made.options.push_back(option_of(of));
    if (!made.reference_bound) made.reference_bound = of.best.error().reference_bound;
    made.constant = std::isinf(of.best.error().baseline);
  }
  made.options.empty() ? tell_shortfall(searched, columns, made) : tell_others(searched, made);
  return made;
}

}  // namespace fde::bench
