// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/candidate_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/measures/accuracy.hpp"
#include "fdebench/benchmarks/observers/comparison_steps.hpp"
#include "fdebench/schemes/stepping/setup_time.hpp"

namespace fde::bench {
StepsOrTolerance resolution_of(const CandidateRun& attempt) {
  if (attempt.requested_tolerance)
    return Tolerance{*attempt.requested_tolerance, *attempt.requested_tolerance};
  return attempt.steps;
}

RunEvaluator::RunEvaluator(const Scene& scene, AccuracyTarget target)
    : scene_(scene), target_(std::move(target)), reference_(scene) {}

Rows RunEvaluator::compared_columns(const Rows& columns) const {
  return columns(target_.columns, Eigen::all);
}

Trajectory RunEvaluator::solve(const Configuration& configuration, const StepsOrTolerance& resolution,
                               const std::vector<double>& times, double budget) const {
  const RunSettings settings{.resolution = resolution, .grading = configuration.grading};
  return configuration.scheme->solve(scene_.problem, resolution_of(settings, scene_.problem.end),
                                     {.budget = budget, .output_times = times});
}

std::vector<double> RunEvaluator::compared_times(const Configuration& configuration,
                                                 const StepsOrTolerance& resolution, int compared) const {
  const double end = scene_.problem.end;
  if (target_.kind.norm == Norm::end) return {end};
  if (configuration.is_adaptive()) return comparison_times(scene_.problem, compared);
  return comparison_times({.end = end, .steps = std::get<int>(resolution), .grading = configuration.grading},
                          compared);
}

CandidateRun RunEvaluator::evaluate(const Configuration& configuration, const StepsOrTolerance& resolution,
                                    int compared, double budget) {
  const bool at_end = target_.kind.norm == Norm::end;
  const auto times = compared_times(configuration, resolution, compared);
  CandidateRun attempt;
  const SetupTime setup;
  const auto start = std::chrono::steady_clock::now();
  const auto path = solve(configuration, resolution, times, budget);
  attempt.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (const auto* requested = std::get_if<Tolerance>(&resolution)) {
    attempt.requested_tolerance = requested->rtol;
    attempt.steps = static_cast<int>(path.steps);
  } else {
    attempt.steps = std::get<int>(resolution);
  }
  attempt.setup_seconds = setup.seconds();
  attempt.first_run = target_.first_run;
  attempt.ending = outcome_of(scene_.problem, path);
  if (path.status != SolveStatus::finished) return attempt;
  const Rows values = compared_columns(columns_of(scene_.outputs, path));
  if (const auto gap = first_not_finite(values)) {
    attempt.ending = {SolveStatus::non_finite, at_time(std::nullopt, path.time(*gap))};
    return attempt;
  }
  at_end ? measure_end_error(values, attempt) : measure_maximum_error(values, path.times, attempt);
  constexpr double nearly = 1e-9;
  if (attempt.baseline_error < nearly && is_constant())
    attempt.baseline_error = std::numeric_limits<double>::infinity();
  if (!at_end && !configuration.is_adaptive()) {
    const Grid grid{.end = scene_.problem.end, .steps = attempt.steps, .grading = configuration.grading};
    const Vec unresolved = samples().variation.unresolved_variation(grid, smallest_order(scene_.problem));
    attempt.error = std::max(attempt.error, unresolved.maxCoeff());
  }
  attempt.meets_accuracy = is_accurate(attempt);
  return attempt;
}

bool RunEvaluator::is_accurate(const CandidateRun& attempt) const {
  return attempt.error + attempt.reference_bound <= target_.accuracy &&
         attempt.error < attempt.baseline_error;
}

void RunEvaluator::compare_at_own_steps(const Configuration& configuration, CandidateRun& run) {
  const auto path = solve(configuration, resolution_of(run), {}, std::numeric_limits<double>::infinity());
  if (path.status != SolveStatus::finished || path.y.cols() < 2) return;
  const auto steps = comparison_steps(static_cast<int>(path.y.cols()) - 1, evenly_spaced_comparisons);
  std::vector<double> times;
  for (const int step : steps) times.push_back(path.time(step));
  const Rows values = compared_columns(columns_of(scene_.outputs, path));
  if (!values.allFinite()) return;
  CandidateRun at_steps;
  measure_maximum_error(values(Eigen::all, steps), times, at_steps);
  run.baseline_error = std::max(run.baseline_error, at_steps.baseline_error);
  run.reference_bound = std::max(run.reference_bound, at_steps.reference_bound);
  if (at_steps.error > run.error) {
    run.error = at_steps.error;
    run.column = at_steps.column;
    run.time = at_steps.time;
  }
  run.meets_accuracy = is_accurate(run);
}

void RunEvaluator::time_again(const Configuration& configuration, CandidateRun& run) const {
  constexpr double long_enough = 2e-4, long_solve = 5e-3;
  const int fewest = run.seconds < long_solve ? 2 : 1;
  double total = 0.0, least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < fewest || total < long_enough; ++i) {
    const auto start = std::chrono::steady_clock::now();
    solve_for_timing(configuration, resolution_of(run));
    const double taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    least = std::min(least, taken);
    total += taken;
  }
  run.seconds = least + run.counted_setup();
}

void RunEvaluator::solve_for_timing(const Configuration& configuration,
                                    const StepsOrTolerance& resolution) const {
  static_cast<void>(
      solve(configuration, resolution, {scene_.problem.end}, std::numeric_limits<double>::infinity()));
}

void RunEvaluator::precompute_reference(int times) {
  reference_.at(comparison_times({.end = scene_.problem.end, .steps = times}));
}

Rows RunEvaluator::finite_reference(const std::vector<double>& times) {
  Rows reference = compared_columns(reference_.at(times));
  if (const auto column = first_not_finite(reference)) {
    throw std::runtime_error(
        fmt::format("the solution overflows at t = {:.6g}: nothing can be compared with it",
                    times[static_cast<std::size_t>(*column)]));
  }
  return reference;
}

void RunEvaluator::measure_maximum_error(const Rows& values, const std::vector<double>& times,
                                         CandidateRun& attempt) {
  const Rows reference = finite_reference(times);
  const Rows by = divisors(target_.kind.scale, times, reference);
  Eigen::Index row = 0, column = 0;
  attempt.error = (values - reference).cwiseAbs().cwiseQuotient(by).maxCoeff(&row, &column);
  attempt.baseline_error = constant_solution_error(Norm::maximum, times, reference, by);
  attempt.reference_bound = compared_columns(reference_.bounds(times)).cwiseQuotient(by).maxCoeff();
  attempt.column = target_.columns[static_cast<std::size_t>(row)];
  attempt.time = times[static_cast<std::size_t>(column)];
}

const RunEvaluator::Samples& RunEvaluator::samples() {
  if (samples_) return *samples_;
  constexpr int evenly = 64;
  auto times = comparison_times(scene_.problem, evenly);
  Rows reference = finite_reference(times);
  Rows by = divisors(target_.kind.scale, times, reference);
  Rows bounds = compared_columns(reference_.bounds(times));
  TotalVariation variation(std::move(times), reference, by);
  return samples_.emplace(
      Samples{std::move(reference), std::move(bounds), std::move(by), std::move(variation)});
}

bool RunEvaluator::is_constant() { return bench::is_constant(samples().reference, samples().bounds); }

double RunEvaluator::reference_bound() {
  if (target_.kind.norm == Norm::end) return at_end().bound;
  return samples().bounds.cwiseQuotient(samples().divisors).maxCoeff();
}

void RunEvaluator::measure_end_error(const Rows& values, CandidateRun& attempt) {
  const auto& [reference, by, baseline, bound] = at_end();
  const Vec difference = values.rightCols(1) - reference.rightCols(1);
  Eigen::Index row = 0;
  attempt.error = difference.cwiseAbs().cwiseQuotient(by.rightCols(1)).maxCoeff(&row);
  attempt.baseline_error = baseline;
  attempt.reference_bound = bound;
  attempt.column = target_.columns[static_cast<std::size_t>(row)];
  attempt.time = scene_.problem.end;
  if (difference.size() == 1) attempt.signed_error = difference[0];
}

// Times: t = 0 for the baseline y = y(0), and the last tenth of the interval for the relative scale; the
// whole interval for the peak.
const RunEvaluator::EndComparison& RunEvaluator::at_end() {
  if (at_end_) return *at_end_;
  constexpr int nearby = 64;
  const double end = scene_.problem.end;
  std::vector<double> times{0.0};
  if (target_.kind.scale == Scale::peak) {
    for (const double t : comparison_times(scene_.problem, 9 * nearby))
      if (t > 0.0 && t < 0.9 * end) times.push_back(t);
  }
  for (int i = 0; i <= nearby; ++i) times.push_back(end * (9 * nearby + i) / (10 * nearby));
  Rows reference = finite_reference(times);
  Rows by = divisors(target_.kind.scale, times, reference);
  const double baseline = constant_solution_error(Norm::end, times, reference, by);
  const Vec unknown = reference_.bounds({end})(target_.columns, 0);
  const double bound = unknown.cwiseQuotient(by.rightCols(1)).maxCoeff();
  return at_end_.emplace(EndComparison{std::move(reference), std::move(by), baseline, bound});
}

}  // namespace fde::bench
