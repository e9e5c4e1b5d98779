// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/observers/comparison_steps.hpp"
#include "fdebench/benchmarks/records/run_settings.hpp"
#include "fdebench/benchmarks/search/configurations.hpp"
#include "fdebench/benchmarks/search/interleaved_times.hpp"
#include "fdebench/benchmarks/search/next_resolution.hpp"
#include "fdebench/benchmarks/search/run_evaluator.hpp"
#include "fdebench/benchmarks/search/search_outcome.hpp"

namespace fde::bench {
namespace {

using Clock = std::chrono::steady_clock;

// Configurations within this factor of the quickest, by few solves of each, are timed against it.
constexpr double margin = 1.5;

// The fraction of the time left that one run may take.
constexpr double most_of_rest = 0.3;

// The part of the accuracy that the bound of the reference may take. Runs must be within the rest.
constexpr double most_unknown = 0.9;

class Search {
 public:
  Search(const Scene& scene, const AccuracyTarget& target, double seconds, const SearchProgress& progress,
         std::span<const Scheme* const> own)
      : evaluator_(scene, target), seconds_(seconds), progress_(progress) {
    for (auto& choice : configurations_of(scene, target.kind.norm, own)) {
      refinements_.push_back({.is_adaptive = choice.configuration.is_adaptive(),
                              .is_closed = choice.refused.has_value(),
                              .unit = choice.unit});
      candidates_.push_back({.configuration = choice.configuration,
                             .outcome = choice.refused ? SearchOutcome::refused : SearchOutcome::out_of_time,
                             .reason = choice.refused.value_or(""),
                             .names = {std::string(choice.configuration.scheme->id)}});
    }
  }

  std::vector<SearchCandidate> run() {
    if (evaluator_.reference_bound() >= most_unknown * accuracy()) {
      throw std::runtime_error(
          fmt::format("the reference is known up to {:.1e} only, which is no less than {} times {:.1e}",
                      evaluator_.reference_bound(), most_unknown, accuracy()));
    }
    set_comparison_times();
    goal_.targets = {{0, accuracy() - evaluator_.reference_bound(), at_end()}};
    bool is_confirmed = false;
    do {  // each turn makes runs, or confirms the quickest one
      while (make_next_runs()) {
      }
      merge_repeats();
      is_confirmed = time_and_verify();
    } while (left() > 0.0 && (!is_confirmed || has_next_runs()));
    while (!is_confirmed) is_confirmed = time_and_verify();  // ends: a run is verified once
    const bool has_time = left() > 0.0;
    const double least = quickest();
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      candidates_[i].refinement = std::move(refinements_[i]);
      conclude(candidates_[i], goal_.targets.front(), least, has_time);
    }
    std::ranges::stable_sort(candidates_, {}, rank);
    return std::move(candidates_);
  }

 private:
  // Sets at how many times runs are compared, from the measured cost of one reference value.
  void set_comparison_times() {
    constexpr int most = 512, least = 64, most_at_last = max_comparison_steps;
    constexpr double usual_seconds = 5.0;
    const auto start = Clock::now();
    constexpr int some = 8;
    evaluator_.precompute_reference(some);
    const double each = std::max(1e-9, std::chrono::duration<double>(Clock::now() - start).count() / some);
    const double seconds = std::min(seconds_, usual_seconds);
    comparison_times_ = static_cast<int>(std::clamp(seconds / (300.0 * each), 1.0 * least, 1.0 * most));
    final_comparison_times_ =
        static_cast<int>(std::clamp(seconds / (10.0 * each), 1.0 * most, 1.0 * most_at_last));
  }

  [[nodiscard]] double elapsed() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }
  // Seconds left for runs: 70 % of the time is for them, the rest for timing.
  [[nodiscard]] double left() const { return std::max(0.0, 0.7 * seconds_ - elapsed()); }

  [[nodiscard]] bool at_end() const { return evaluator_.target().kind.norm == Norm::end; }
  [[nodiscard]] double accuracy() const { return evaluator_.target().accuracy; }
  [[nodiscard]] double quickest() const { return quickest_seconds(goal_, refinements_).front(); }

  std::vector<std::optional<StepsOrTolerance>> next_runs() {
    constexpr double part_of_scan = 0.1, runs_of_scan = 25.0, long_solve = 0.05;
    goal_.most_seconds = most_of_rest * left();
    goal_.budget_of_tolerance = budget_of_tolerance();
    goal_.most_seconds_scanned = part_of_scan * left() / runs_of_scan;
    goal_.closeness = quickest() < long_solve ? 1.015 : 1.1;
    return next_resolutions(goal_, refinements_);
  }

  [[nodiscard]] bool has_next_runs() {
    return left() > 0.0 &&
           std::ranges::any_of(next_runs(), [](const auto& next) { return next.has_value(); });
  }

  // Makes the next runs that are due. Returns whether there was any.
  bool make_next_runs() {
    const auto next = next_runs();
    const auto due = due_runs(goal_, refinements_, next);
    for (const std::size_t i : due) {
      if (left() == 0.0) return false;
      make_run(i, *next[i]);
    }
    return !due.empty();
  }

  void make_run(std::size_t i, const StepsOrTolerance& resolution) {
    const SearchCandidate& of = candidates_[i];
    RefinementRun made = evaluated(of, resolution, comparison_times_);
    constexpr double short_run = 0.1;
    // The first solve may compute start weights; it allocates, and stores the compared values.
    if (made.ending.kind != SolveStatus::out_of_budget && made.seconds &&
        (*made.seconds < short_run || made.setup_seconds > 0.0))
      evaluator_.time_again(of.configuration, made);
    refinements_[i].add(std::move(made));
  }

  RefinementRun evaluated(const SearchCandidate& of, const StepsOrTolerance& resolution, int compared) {
    const RunSettings settings{.resolution = resolution, .grading = of.configuration.grading};
    progress_(fmt::format("{} {}", of.configuration.scheme->id, resolution_text(settings)),
              std::min(1.0, elapsed() / seconds_));
    const bool is_adaptive = of.configuration.is_adaptive();
    return evaluator_.evaluate(of.configuration, resolution, compared,
                               is_adaptive ? budget_of_tolerance() : std::max(1.0, left()));
  }

  // A run that takes many times as long as the quickest one cannot be the best; before there is one, a run
  // that takes many times as long as all others so far.
  [[nodiscard]] double budget_of_tolerance() const {
    constexpr double shortest = 0.05, part = 0.1, far = 10.0;
    double longest = 0.0;
    for (const Refinement& of : refinements_)
      for (const RefinementRun& run : of.runs) longest = std::max(longest, run.seconds.value_or(0.0));
    const double usual = std::isfinite(quickest()) ? quickest() : longest;
    return std::clamp(far * usual, shortest, std::max(shortest, part * left()));
  }

  // Gives configurations that are one algorithm all its names, where they have few runs after more of them.
  // The quicker one is kept: what is the same algorithm here may be computed in another way.
  void merge_repeats() {
    for (std::size_t second = 0; second < candidates_.size(); ++second) {
      for (std::size_t first = 0; first < second; ++first) {
        if (is_merged(second) || is_merged(first)) continue;
        if (candidates_[first].configuration.grading != candidates_[second].configuration.grading) continue;
        if (!is_same_algorithm(refinements_[first], refinements_[second], 1) || !is_confirmed(first, second))
          continue;
        is_quicker(second, first) ? merge(first, second) : merge(second, first);
      }
    }
  }

  // By more than times scatter.
  [[nodiscard]] bool is_quicker(std::size_t a, std::size_t b) const {
    constexpr double clearly = 0.9;
    const auto *mine = best_run(a), *other = best_run(b);
    return mine != nullptr && other != nullptr && *mine->seconds < clearly * *other->seconds;
  }

  void merge(std::size_t repeated, std::size_t kept) {
    if (candidates_[kept].configuration.scheme != candidates_[repeated].configuration.scheme)
      std::ranges::copy(candidates_[repeated].names, std::back_inserter(candidates_[kept].names));
    candidates_[repeated].outcome = SearchOutcome::duplicate;
    refinements_[repeated].is_closed = true;
    refinements_[repeated].runs.clear();  // so that the one that is kept repeats nothing
  }

  [[nodiscard]] bool is_merged(std::size_t i) const {
    return candidates_[i].outcome == SearchOutcome::duplicate;
  }

  // Whether both give the same errors at five numbers of steps.
  bool is_confirmed(std::size_t first, std::size_t second) {
    for (int runs = 0, steps = goal_.coarsest_steps; runs < fewest_equal_runs; ++runs, steps *= 2) {
      if (is_same_algorithm(refinements_[first], refinements_[second])) return true;
      for (const std::size_t i : {first, second}) {
        const int next = steps * refinements_[i].unit;
        if (std::ranges::find(refinements_[i].runs, StepsOrTolerance(next), &RefinementRun::resolution) ==
            refinements_[i].runs.end())
          make_run(i, next);
      }
    }
    return is_same_algorithm(refinements_[first], refinements_[second]);
  }

  // The quickest run within the accuracy; nullptr: none.
  [[nodiscard]] const RefinementRun* best_run(std::size_t i) const {
    return is_merged(i) ? nullptr : quickest_within(refinements_[i], goal_.targets.front());
  }

  // Times the quickest configurations against each other and compares the best with the reference at more
  // times. Returns false if its error is then outside the accuracy, so that the search goes on.
  bool time_and_verify() {
    std::vector<std::size_t> quick;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      candidates_[i].time.reset();
      const auto* best = best_run(i);
      if (best != nullptr && *best->seconds <= margin * quickest()) quick.push_back(i);
    }
    if (quick.empty()) return true;
    std::vector<TimedSolve> solves;
    for (const std::size_t i : quick) {
      const RefinementRun& best = *best_run(i);
      solves.push_back({[this, i, resolution = best.resolution] {
                          evaluator_.solve_for_timing(candidates_[i].configuration, resolution);
                        },
                        *best.seconds});
    }
    progress_(fmt::format("timing {} runs", quick.size()), std::min(1.0, elapsed() / seconds_));
    const auto start = Clock::now();
    const auto times = time_interleaved(solves, part_of_timing * timing_seconds_left_);
    timing_seconds_left_ -= std::chrono::duration<double>(Clock::now() - start).count();
    for (std::size_t k = 0; k < quick.size(); ++k) take_time(quick[k], times[k]);
    const bool is_overtaken =
        std::ranges::none_of(quick, [&](std::size_t i) { return *best_run(i)->seconds <= quickest(); });
    if (is_overtaken && left() > 0.0) return false;
    const auto first =
        *std::ranges::min_element(quick, {}, [&](std::size_t i) { return candidates_[i].time->median; });
    return verify(first);
  }

  void take_time(std::size_t i, MedianInterval time) {
    const RefinementRun* best = best_run(i);
    const double more = best->counted_setup();
    for (double* seconds : {&time.median, &time.low, &time.high}) *seconds += more;
    candidates_[i].time = time;
    // What made this run slower or quicker than it was before makes the others of the configuration so too.
    const double factor = time.median / *best->seconds;
    for (RefinementRun& run : refinements_[i].runs) {
      if (run.seconds) *run.seconds *= factor;
    }
  }

  // Compares the best run with the reference at more times, with adaptive step size at its own steps; returns
  // whether it is within the accuracy there.
  bool verify(std::size_t i) {
    const auto number = best_run(i) - refinements_[i].runs.data();
    RefinementRun& made = refinements_[i].runs[static_cast<std::size_t>(number)];
    if (at_end() || !verified_.insert({i, number}).second) return true;
    const Configuration& configuration = candidates_[i].configuration;
    const int more = configuration.is_adaptive()
                         ? std::min(final_comparison_times_, evenly_spaced_comparisons)
                         : final_comparison_times_;
    RefinementRun again = evaluated(candidates_[i], made.resolution, more);
    if (configuration.is_adaptive() && again.ending.kind == SolveStatus::finished)
      evaluator_.compare_at_own_steps(configuration, again);
    again.seconds = made.seconds;
    again.setup_seconds = made.setup_seconds;
    made = std::move(again);
    return is_within(made, goal_.targets.front());
  }

  // Sort key: timed configurations first, by time; then by outcome.
  static std::pair<int, double> rank(const SearchCandidate& of) {
    if (of.time) return {-1, of.time->median};
    return {static_cast<int>(of.outcome), of.best.seconds.value_or(0.0)};
  }

  static constexpr double timing_part = 0.05;        // of the time of the search, for all timings
  static constexpr double part_of_timing = 1.0 / 3;  // of what is left of it, for one
  RunEvaluator evaluator_;
  double seconds_;
  const SearchProgress& progress_;
  Clock::time_point start_ = Clock::now();
  double timing_seconds_left_ = timing_part * seconds_;
  SearchGoal goal_{};
  std::vector<SearchCandidate> candidates_{};
  std::vector<Refinement> refinements_{};  // one entry for each of candidates_: its runs until run() ends
  int comparison_times_ = 0, final_comparison_times_ = 0;
  std::set<std::pair<std::size_t, std::ptrdiff_t>> verified_{};  // indices of candidates and their runs
};

}  // namespace

std::vector<SearchCandidate> search(const Scene& scene, const AccuracyTarget& target, double seconds,
                                    const SearchProgress& progress, std::span<const Scheme* const> own) {
  return Search(scene, target, seconds, progress, own).run();
}

}  // namespace fde::bench
