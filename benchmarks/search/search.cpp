// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/observers/comparison_steps.hpp"
#include "fdebench/benchmarks/records/run_settings.hpp"
#include "fdebench/benchmarks/search/fewest_steps.hpp"
#include "fdebench/benchmarks/search/interleaved_times.hpp"
#include "fdebench/benchmarks/search/largest_tolerance.hpp"
#include "fdebench/schemes/stepping/rates.hpp"

namespace fde::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int coarsest_steps = 4;
constexpr std::size_t runs_to_compare = 5;  // equal bits in so many runs: both schemes are one algorithm

// Configurations within this factor of the quickest, by one solve of each, are timed against it.
constexpr double margin = 1.5;

// The fraction of the time left that one run may take.
constexpr double most_of_rest = 0.3;

// A configuration is refined while its expected time is below this multiple of the time left.
constexpr double far = 10.0;

bool is_hopeless(const OutcomeKind& kind) {
  return kind == SolveStatus::left_domain || kind == SolveStatus::out_of_budget;
}

// The smallest number of equal steps whose times contain all jumps of the right-hand side; 1 if there is none
// up to 1000.
int meeting_jumps(const Problem& problem) {
  constexpr int most = 1000;
  for (int steps = 1; steps <= most; ++steps) {
    if (has_breaking_points(problem, Grid{problem.end, steps})) return steps;
  }
  return 1;
}

class Search {
 public:
  Search(const Scene& scene, const AccuracyTarget& question, double seconds, const SearchProgress& progress)
      : evaluator_(scene, question),
        unit_(meeting_jumps(scene.problem)),
        seconds_(seconds),
        progress_(progress) {
    for (const Scheme& scheme : schemes()) add_configurations(scheme);
  }

  std::vector<SearchCandidate> run() {
    if (evaluator_.reference_bound() >= accuracy()) {
      throw std::runtime_error(
          fmt::format("the reference is known up to {:.1e} only, which is no less than {:.1e}",
                      evaluator_.reference_bound(), accuracy()));
    }
    set_comparison_times();
    do {
      while (refine()) {
      }
      for (std::size_t i = 0; i < candidates_.size(); ++i) merge_repeats(i);
      while (!time_and_verify()) {
      }
    } while (resume_slower());
    for (SearchCandidate& of : candidates_) predict(of);
    std::ranges::stable_sort(candidates_, {}, rank);
    return std::move(candidates_);
  }

 private:
  void add_configurations(const Scheme& scheme) {
    const Scene& scene = evaluator_.scene();
    const auto why_not = [&](double grading) {
      Resolution resolution = Grid{.end = scene.problem.end, .steps = coarsest_steps, .grading = grading};
      if (scheme.capabilities.is_adaptive()) resolution = Tolerance{accuracy(), accuracy()};
      return unsupported_reason(scheme, scene.problem, resolution);
    };
    const auto refused = why_not(1.0);
    for (const double grading :
         refused ? std::vector{1.0} : gradings_of(scheme, scene, evaluator_.question().kind.norm)) {
      if (!refused && why_not(grading)) continue;
      candidates_.push_back({.configuration = {&scheme, grading},
                             .outcome = refused ? SearchOutcome::refused : SearchOutcome::out_of_time,
                             .reason = refused.value_or(""),
                             .names = {std::string(scheme.id)}});
      active_.push_back(!refused);
    }
  }

  // Sets at how many times runs are compared, from the measured cost of one reference value. All runs with
  // adaptive step size are compared at the same times.
  void set_comparison_times() {
    constexpr int most = 512, least = 64, most_at_last = max_comparison_steps;
    const auto start = Clock::now();
    constexpr int some = 8;
    evaluator_.precompute_reference(some);
    const double each = std::max(1e-9, std::chrono::duration<double>(Clock::now() - start).count() / some);
    comparison_times_ = static_cast<int>(std::clamp(seconds_ / (300.0 * each), 1.0 * least, 1.0 * most));
    final_comparison_times_ =
        static_cast<int>(std::clamp(seconds_ / (10.0 * each), 1.0 * most, 1.0 * most_at_last));
    adaptive_comparison_times_ = std::min(final_comparison_times_, evenly_spaced_comparisons);
  }

  [[nodiscard]] double elapsed() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }
  // Seconds left for runs: 70 % of the time is for them, the rest for timing.
  [[nodiscard]] double left() const { return std::max(0.0, 0.7 * seconds_ - elapsed()); }

  [[nodiscard]] double accuracy() const { return evaluator_.question().accuracy; }

  CandidateRun examine(const SearchCandidate& of, int steps, int compared) {
    progress_(
        fmt::format("{} {} N = {}", of.configuration.scheme->id, grid_text(of.configuration.grading), steps),
        std::min(1.0, elapsed() / seconds_));
    return evaluator_.evaluate(of.configuration, steps, compared, std::max(1.0, left()));
  }

  // The budget is a multiple of the quickest run so far: a slower run cannot be the best.
  CandidateRun evaluate_adaptive(const SearchCandidate& of, double requested) {
    constexpr double shortest = 0.05, part = 0.1;
    progress_(fmt::format("{} accuracy = {:.1e}", of.configuration.scheme->id, requested),
              std::min(1.0, elapsed() / seconds_));
    const double budget = std::clamp(far * quickest_, shortest, std::max(shortest, part * left()));
    return evaluator_.evaluate(of.configuration, Tolerance{requested, requested}, adaptive_comparison_times_,
                               budget);
  }

  // One more run for each active configuration that is not expected to be slower than another. Returns
  // whether any is still active.
  bool refine() {
    double expected = quickest_;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      if (active_[i])
        expected = std::min(expected, expected_seconds(candidates_[i], accuracy(), &Prediction::high));
    }
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      if (!active_[i] || lower_bound_of_seconds(candidates_[i], accuracy()) > margin * expected) continue;
      active_[i] = refine(candidates_[i]);
      if (candidates_[i].refinements.size() == runs_to_compare) merge_repeats(i);
    }
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      if (!active_[i] || lower_bound_of_seconds(candidates_[i], accuracy()) <= margin * quickest_) continue;
      candidates_[i].outcome = SearchOutcome::slower;
      active_[i] = false;
    }
    return std::ranges::find(active_, true) != active_.end();
  }

  // Makes the next refinement, or all runs with adaptive step size. Returns whether to go on refining.
  bool refine(SearchCandidate& of) {
    if (of.configuration.is_adaptive()) {
      run_adaptive(of);
      return false;
    }
    const int steps =
        of.refinements.empty() ? std::max(coarsest_steps, unit_) : 2 * of.refinements.back().steps;
    if (steps > most_steps_ / 2 || next_seconds(of) > most_of_rest * left()) return false;
    of.refinements.push_back(examine(of, steps, comparison_times_));
    if (of.refinements.size() == 1 && of.configuration.scheme->starting_powers) exclude_setup_time(of);
    const CandidateRun& last = of.refinements.back();
    of.seconds_per_step = last.seconds / last.steps;
    if (last.meets_accuracy) {
      find_fewest(of);
      return false;
    }
    if (search_sign_change(of)) return false;
    if (is_hopeless(last.ending.kind)) {
      of.outcome =
          last.ending.kind == SolveStatus::out_of_budget ? SearchOutcome::out_of_time : SearchOutcome::failed;
      of.reason = sentence(last.ending);
      return false;
    }
    if (has_stagnated(of)) {
      of.outcome = SearchOutcome::stagnated;
      return false;
    }
    return lower_bound_of_seconds(of, accuracy()) < far * left();
  }

  // The first solve computes the starting weights, which are cached; the time without them is compared.
  void exclude_setup_time(SearchCandidate& of) const {
    CandidateRun& first = of.refinements.front();
    const double whole = first.seconds;
    time_again(of.configuration, first);
    of.setup_seconds = whole - first.seconds;
  }

  // All runs of a scheme with adaptive step size.
  void run_adaptive(SearchCandidate& of) {
    auto found = largest_tolerance(accuracy(), [&](double requested) {
      of.refinements.push_back(evaluate_adaptive(of, requested));
      return of.refinements.back();
    });
    if (found) {
      of.best = std::move(*found);
      of.outcome = SearchOutcome::accuracy_reached;
      time_best(of);
      return;
    }
    const RunOutcome& last = of.refinements.back().ending;
    const bool finished = last.kind == SolveStatus::finished;
    of.outcome = finished ? SearchOutcome::stagnated : SearchOutcome::failed;
    if (last.kind == SolveStatus::out_of_budget) of.outcome = SearchOutcome::slower;
    of.reason = sentence(last);
  }

  // If the error changes its sign between the last two runs, searches there for a run within the accuracy.
  // Returns whether there is one.
  bool search_sign_change(SearchCandidate& of) {
    const auto& refinements = of.refinements;
    if (refinements.size() < 2 ||
        refinements.back().signed_error * refinements[refinements.size() - 2].signed_error >= 0.0)
      return false;
    auto found = at_sign_change(refinements[refinements.size() - 2], refinements.back(), unit_,
                                [&](int steps) { return examine(of, steps, comparison_times_); });
    if (!found) return false;
    of.best = std::move(*found);
    of.outcome = SearchOutcome::accuracy_reached;
    quickest_ = std::min(quickest_, of.best.seconds);
    return true;
  }

  void find_fewest(SearchCandidate& of) {
    // A scan costs about 25 times the longest run and may take a tenth of the time left.
    constexpr double runs_of_scan = 25.0, part_of_scan = 0.1;
    constexpr int few_steps = 64;  // with so few steps the error need not be monotone in N
    const auto attempt = [&](int steps) { return examine(of, steps, comparison_times_); };
    const bool may_pass_zero = evaluator_.question().kind.norm == Norm::end;
    const bool is_short = runs_of_scan * of.refinements.back().seconds < part_of_scan * left();
    const bool scan = is_short && (may_pass_zero || of.refinements.back().steps <= few_steps);
    of.best = fewest_steps(of.refinements, accuracy(), unit_, scan, attempt);
    of.outcome = SearchOutcome::accuracy_reached;
    time_best(of);
  }

  void time_best(SearchCandidate& of) {
    time_again(of.configuration, of.best);
    quickest_ = std::min(quickest_, of.best.seconds);
  }

  void time_again(const Configuration& configuration, CandidateRun& attempt) const {
    constexpr int more_solves = 2;
    constexpr double part = 0.1;  // largest fraction of the time left for one solve
    for (int i = 0; i < more_solves && attempt.seconds < part * left(); ++i)
      attempt.seconds = std::min(attempt.seconds, seconds_to_end(configuration, attempt));
  }

  [[nodiscard]] double seconds_to_end(const Configuration& configuration, const CandidateRun& as) const {
    const auto start = Clock::now();
    evaluator_.solve_for_timing(configuration, resolution_of(as));
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  // Merges a configuration into an earlier one that gives the same bits.
  void merge_repeats(std::size_t second) {
    for (std::size_t first = 0; first < second && candidates_[second].outcome != SearchOutcome::duplicate;
         ++first) {
      if (!is_repeated(candidates_[first], candidates_[second])) continue;
      candidates_[first].names.emplace_back(candidates_[second].configuration.scheme->id);
      candidates_[second].outcome = SearchOutcome::duplicate;
      active_[second] = false;
    }
  }

  bool is_repeated(const SearchCandidate& first, const SearchCandidate& second) {
    const auto is_alive = [](const SearchCandidate& of) {
      return of.outcome == SearchOutcome::accuracy_reached || of.outcome == SearchOutcome::out_of_time;
    };
    if (first.configuration.is_adaptive() || second.configuration.is_adaptive()) return false;
    if (!is_alive(first) || !is_alive(second) || first.configuration.grading != second.configuration.grading)
      return false;
    const std::size_t common = std::min(first.refinements.size(), second.refinements.size());
    const auto same = [](const CandidateRun& a, const CandidateRun& b) {
      const bool comparable = a.steps == b.steps && a.values.cols() == b.values.cols();
      return std::isfinite(a.error) && comparable && a.values == b.values;
    };
    return common > 0 &&
           std::ranges::equal(std::span(first.refinements).first(common),
                              std::span(second.refinements).first(common), same) &&
           evaluator_.same_values(first.configuration, second.configuration,
                                  second.refinements[common - 1].steps);
  }

  // Predicts the error of `best`, or the steps needed, by the error model of the refinements.
  void predict(SearchCandidate& of) const {
    if (of.configuration.is_adaptive()) return;
    const auto errors = errors_of(of);
    const ErrorModel model(errors);
    if (model.empty()) return;
    if (of.outcome == SearchOutcome::accuracy_reached) of.predicted = model.error(of.best.steps);
    if (of.outcome != SearchOutcome::accuracy_reached && !is_asymptotic(of)) return;
    of.rate = observed_rate(errors);
    if (of.outcome == SearchOutcome::slower || of.outcome == SearchOutcome::out_of_time)
      of.steps_needed = model.steps(accuracy());
  }

  // Times the quickest configurations against each other and compares the best with the reference at more
  // times. Returns false if `best` needed more steps for that, so that the timing has to be repeated.
  bool time_and_verify() {
    std::vector<SearchCandidate*> quick;
    for (SearchCandidate& of : candidates_) {
      of.time.reset();
      if (of.outcome == SearchOutcome::accuracy_reached && of.best.seconds <= margin * quickest_)
        quick.push_back(&of);
    }
    if (quick.empty()) return true;
    std::vector<std::function<void()>> solves;
    for (const auto* of : quick) {
      solves.emplace_back(
          [this, of] { evaluator_.solve_for_timing(of->configuration, resolution_of(of->best)); });
    }
    progress_(fmt::format("timing {} runs", quick.size()), std::min(1.0, elapsed() / seconds_));
    const auto times = time_interleaved(solves, timing_part * seconds_);
    for (std::size_t i = 0; i < quick.size(); ++i) quick[i]->time = times[i];
    auto& first = **std::ranges::min_element(quick, {}, [](const auto* of) { return of->time->median; });
    return verify(first);
  }

  // Resumes configurations given up as slower whose lower estimate is below the measured time of the best.
  // Returns whether any is active again.
  bool resume_slower() {
    quickest_ = infinity;
    for (const SearchCandidate& of : candidates_) {
      if (of.time) quickest_ = std::min(quickest_, of.time->median);
    }
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      if (candidates_[i].outcome != SearchOutcome::slower || candidates_[i].configuration.is_adaptive())
        continue;
      if (lower_bound_of_seconds(candidates_[i], accuracy()) > quickest_) continue;
      candidates_[i].outcome = SearchOutcome::out_of_time;
      active_[i] = left() > 0.0;
    }
    return std::ranges::find(active_, true) != active_.end();
  }

  // Repeats a run with a comparison at more times.
  CandidateRun examine_again(const SearchCandidate& of, const CandidateRun& as) {
    return as.requested_tolerance ? evaluate_adaptive(of, *as.requested_tolerance)
                                  : examine(of, as.steps, final_comparison_times_);
  }

  // The same run with 1 % more steps or 0.8 times the tolerance.
  [[nodiscard]] CandidateRun next(CandidateRun attempt) const {
    constexpr double tighter = 0.8;
    if (attempt.requested_tolerance) {
      *attempt.requested_tolerance *= tighter;
    } else {
      attempt.steps = more_steps(attempt.steps, unit_);
    }
    return attempt;
  }

  // Refines `first.best` until it is within the accuracy at more comparison times. Returns whether it was so
  // without refinement.
  bool verify(SearchCandidate& first) {
    if (first.best.steps == verified_steps_ && &first == verified_) return true;
    CandidateRun attempt = examine_again(first, first.best);
    const bool within = attempt.meets_accuracy;
    const auto finished = [&] { return attempt.ending.kind == SolveStatus::finished; };
    while (!attempt.meets_accuracy && finished() && attempt.steps < most_steps_)
      attempt = examine_again(first, next(attempt));
    if (!attempt.meets_accuracy) first.outcome = SearchOutcome::stagnated;
    first.best = std::move(attempt);
    verified_ = &first;
    verified_steps_ = first.best.steps;
    return within;
  }

  // Sort key: timed configurations first, by time; then by outcome.
  static std::pair<int, double> rank(const SearchCandidate& of) {
    if (of.time) return {-1, of.time->median};
    return {static_cast<int>(of.outcome), of.best.seconds};
  }

  static constexpr int most_steps_ = 1 << 30;
  static constexpr double timing_part = 0.05;
  RunEvaluator evaluator_;
  int unit_;  // all numbers of steps are multiples of it
  double seconds_;
  const SearchProgress& progress_;
  Clock::time_point start_ = Clock::now();
  std::vector<SearchCandidate> candidates_{};
  std::vector<bool> active_{};  // active, one entry for each of candidates_
  double quickest_ = infinity;  // least seconds of a run within the accuracy
  int comparison_times_ = 0, final_comparison_times_ = 0, adaptive_comparison_times_ = 0;
  const SearchCandidate* verified_ = nullptr;
  int verified_steps_ = 0;
};

}  // namespace

std::vector<SearchCandidate> search(const Scene& scene, const AccuracyTarget& question, double seconds,
                                    const SearchProgress& progress) {
  return Search(scene, question, seconds, progress).run();
}

}  // namespace fde::bench
