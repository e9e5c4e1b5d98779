// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/run_evaluator.hpp"

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

namespace {

// The seconds of a solve, those of all its steps where it grew beyond all numbers before: they take as long.
double seconds_of_all_steps(double taken, const Trajectory& path, const StepsOrTolerance& resolution) {
  const auto* steps = std::get_if<int>(&resolution);
  const bool is_part = steps != nullptr && path.status == SolveStatus::non_finite && path.steps > 0;
  return is_part ? taken * *steps / static_cast<double>(path.steps) : taken;
}

}  // namespace

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

RefinementRun RunEvaluator::evaluate(const Configuration& configuration, const StepsOrTolerance& resolution,
                                     int compared, double budget) {
  const auto* steps = std::get_if<int>(&resolution);
  const RunSettings settings{.resolution = resolution, .grading = configuration.grading};
  if (auto reason = unsupported_reason(*configuration.scheme, scene_.problem,
                                       resolution_of(settings, scene_.problem.end))) {
    return {.resolution = resolution,
            .steps = steps != nullptr ? *steps : 0,
            .ending = {SolveStatus::refused, std::move(*reason)},
            .errors = {RunError{.baseline = 0.0}}};
  }
  const auto times = compared_times(configuration, resolution, compared);
  const SetupTime setup;
  const auto start = std::chrono::steady_clock::now();
  const auto path = solve(configuration, resolution, times, budget);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  RefinementRun run{.resolution = resolution,
                    .steps = steps != nullptr ? *steps : static_cast<int>(path.steps),
                    .seconds = seconds_of_all_steps(taken.count(), path, resolution),
                    .setup_seconds = setup.seconds(),
                    .first_run = target_.first_run,
                    .fails_with_more_steps = path.status == SolveStatus::out_of_budget,
                    .ending = outcome_of(scene_.problem, path),
                    .errors = {RunError{.baseline = 0.0}}};
  if (path.status != SolveStatus::finished) return run;
  const Rows values = compared_columns(columns_of(scene_.outputs, path));
  if (const auto gap = first_not_finite(values)) {
    run.ending = {SolveStatus::non_finite, at_time(std::nullopt, path.time(*gap))};
    return run;
  }
  const bool at_end = target_.kind.norm == Norm::end;
  RunError& error = run.errors.front();
  error = at_end ? end_error(values) : maximum_error(values, path.times);
  constexpr double nearly = 1e-9;
  if (error.baseline < nearly && is_constant()) error.baseline = std::numeric_limits<double>::infinity();
  if (!at_end && !configuration.is_adaptive())
    error.value = std::max(error.value, unresolved_variation(configuration, run.steps));
  return run;
}

double RunEvaluator::unresolved_variation(const Configuration& configuration, int steps) {
  const Grid grid{.end = scene_.problem.end, .steps = steps, .grading = configuration.grading};
  return samples().variation.unresolved_variation(grid, smallest_order(scene_.problem)).maxCoeff();
}

bool RunEvaluator::is_accurate(const RefinementRun& run) const {
  const RunError& error = run.error();
  return error.value + error.reference_bound <= target_.accuracy && error.value < error.baseline;
}

void RunEvaluator::compare_at_own_steps(const Configuration& configuration, RefinementRun& run) {
  // A step next to an event at which y jumps is as far off as y jumps, whatever the error of its time.
  if (!scene_.problem.resets.empty()) return;
  const auto path = solve(configuration, run.resolution, {}, std::numeric_limits<double>::infinity());
  if (path.status != SolveStatus::finished || path.y.cols() < 2) return;
  const auto steps = comparison_steps(static_cast<int>(path.y.cols()) - 1, evenly_spaced_comparisons);
  std::vector<double> times;
  for (const int step : steps) times.push_back(path.time(step));
  const Rows values = compared_columns(columns_of(scene_.outputs, path));
  if (!values.allFinite()) return;
  const RunError before = run.error(), at_steps = maximum_error(values(Eigen::all, steps), times);
  RunError& error = run.errors.front();
  if (at_steps.value > before.value) error = at_steps;
  error.baseline = std::max(before.baseline, at_steps.baseline);
  error.reference_bound = std::max(before.reference_bound, at_steps.reference_bound);
}

void RunEvaluator::time_again(const Configuration& configuration, RefinementRun& run) const {
  constexpr double long_enough = 2e-4, long_solve = 5e-3;
  const int fewest = *run.seconds < long_solve ? 2 : 1;
  double total = 0.0, least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < fewest || total < long_enough; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const auto path =
        solve(configuration, run.resolution, {scene_.problem.end}, std::numeric_limits<double>::infinity());
    const double taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    least = std::min(least, seconds_of_all_steps(taken, path, run.resolution));
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

RunError RunEvaluator::maximum_error(const Rows& values, const std::vector<double>& times) {
  const Rows reference = finite_reference(times);
  const Rows by = divisors(target_.kind.scale, times, reference);
  Eigen::Index row = 0, column = 0;
  RunError error{.value = (values - reference).cwiseAbs().cwiseQuotient(by).maxCoeff(&row, &column),
                 .baseline = constant_solution_error(Norm::maximum, times, reference, by)};
  error.column = target_.columns[static_cast<std::size_t>(row)];
  error.time = times[static_cast<std::size_t>(column)];
  error.reference_bound = compared_columns(reference_.bounds(times)).cwiseQuotient(by).maxCoeff();
  return error;
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

RunError RunEvaluator::end_error(const Rows& values) {
  const auto& [reference, by, baseline, bound] = at_end();
  const Vec difference = values.rightCols(1) - reference.rightCols(1);
  Eigen::Index row = 0;
  RunError error{.value = difference.cwiseAbs().cwiseQuotient(by.rightCols(1)).maxCoeff(&row),
                 .baseline = baseline,
                 .signed_value = difference.size() == 1 ? difference[0] : 0.0,
                 .time = scene_.problem.end,
                 .reference_bound = bound};
  error.column = target_.columns[static_cast<std::size_t>(row)];
  return error;
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
