// SPDX-License-Identifier: MIT
#include "fdebench/schemes/diagnostics/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/schemes/diagnostics/modes.hpp"
#include "fdebench/schemes/diagnostics/other_steps.hpp"

namespace fde {

namespace {

// The differences of the largest and the smallest value of each quantity in the last quarter of the steps.
Vec late_ranges(const SolvedRun& run) {
  const auto times = late_times(run.grid);
  Vec least = run.quantities(run.path, times.front()), largest = least;
  for (const double t : times) {
    const Vec values = run.quantities(run.path, t);
    least = least.cwiseMin(values);
    largest = largest.cwiseMax(values);
  }
  return largest - least;
}

// Whether the trapezoidal rule, which damps no oscillation of the equation, leaves on the same grid more than
// twice as much of a component as the run does, where the run may have damped one (may_damp_oscillation), as
// half a sentence. Without such an oscillation the trapezoidal rule may keep a stiff mode that the equation
// damps.
std::optional<std::string> damped_oscillation(const SolvedRun& run) {
  constexpr double many_times = 2.0, part_of_size = 0.5;
  const Scheme& undamped = *find_scheme("product_trapezoidal");
  const auto& components = run.problem.components;
  if (&run.scheme == &undamped || is_two_sided(run.problem)) return std::nullopt;
  // A short run takes less time than the count of its modes.
  const bool count_modes_last =
      !has_eigenvalue_modes(run.problem) && run.problem.size() * run.grid.steps <= longest_settled;
  if (!count_modes_last && !may_damp_oscillation(run)) return std::nullopt;
  auto times = late_times(run.grid);
  std::ranges::copy(spread_times(run.grid), std::back_inserter(times));
  std::ranges::sort(times);
  const auto path = solve_again(run, undamped, run.grid, times);
  if (path.status != SolveStatus::finished) return std::nullopt;
  const SolvedRun other{undamped, run.problem, run.grid, run.options, path, {}, run.functions};
  const Vec here = late_sizes(run), there = late_sizes(other);
  const Vec range_here = late_ranges(run), range_there = late_ranges(other);
  for (Eigen::Index i = 0; i < here.size(); ++i) {
    const bool larger = there[i] > many_times * here[i];
    // Beside a value at rest that both keep.
    const bool moves = range_there[i] > many_times * range_here[i] && range_there[i] > part_of_size * here[i];
    if ((i < run.problem.size() && is_algebraic(components[static_cast<std::size_t>(i)])) ||
        !(larger || moves))
      continue;
    if (count_modes_last && !may_damp_oscillation(run)) return std::nullopt;
    return fmt::format("in the last quarter {} {} {:.3g}, and {:.3g} with {} on the same grid", run.name(i),
                       larger ? "is up to" : "changes by", larger ? here[i] : range_here[i],
                       larger ? there[i] : range_there[i], undamped.id);
  }
  return std::nullopt;
}

// A step longer than the time from a jump, or from 0, to the next, or than an interval with a step limit.
std::optional<std::string> short_feature(const Problem& problem, const Grid& grid) {
  std::vector<std::pair<double, double>> features;
  double begin = 0.0;
  for (const double jump : problem.jump_times) features.emplace_back(std::exchange(begin, jump), jump);
  for (const auto& limit : problem.step_limits) features.emplace_back(limit.from, limit.to);
  for (const auto& [from, to] : features) {
    if (to >= grid.end) continue;
    const int n = grid.nearest_index(to);
    const double longest = grid.step(std::min(grid.steps, std::max(1, n + (grid.time(n) < to ? 1 : 0))));
    if (longest <= to - from) continue;
    return fmt::format("a step of {:.3g} is longer than a feature of the problem, from t = {:.6g} to {:.6g}",
                       longest, from, to);
  }
  return std::nullopt;
}

// The last second differences of a component have opposite signs, and a quarter of them, by which the values
// lie above and below their mean, is a large part of the value.
std::optional<std::string> alternation(const SolvedRun& run) {
  const auto times = last_times(run.grid);
  if (times.size() < 4) return std::nullopt;
  std::vector<Vec> y;
  for (const double t : times) y.push_back(stored_at(run.path, t));
  const Vec before = y[2] - 2.0 * y[1] + y[0], after = y[3] - 2.0 * y[2] + y[1], sizes = late_sizes(run);
  for (Eigen::Index i = 0; i < before.size(); ++i) {
    const double part = 0.25 * std::min(std::abs(before[i]), std::abs(after[i]));
    if (before[i] * after[i] < 0.0 && part > significant_part * sizes[i])
      return fmt::format("{} goes up and down from step to step by {:.3g}", run.name(i), part);
  }
  return std::nullopt;
}

constexpr double looser = 10.0, undecided = 3.0, missed = 5.0;

Tolerance times(const Tolerance& accuracy, double factor) {
  return {.rtol = factor * accuracy.rtol, .atol = factor * accuracy.atol};
}

// The largest |value - other| in units of the tolerance, of which the error of the run is this part.
MissedAccuracy largest_error(const Tolerance& requested, const Rows& values, const Rows& others,
                             double part) {
  MissedAccuracy worst{.times = 0.0, .row = 0, .column = 0};
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
      const double allowed = requested.rtol * std::abs(values(i, c)) + requested.atol;
      const double off = part * std::abs(values(i, c) - others(i, c)) / allowed;
      if (std::isfinite(off) && off > worst.times) worst = {.times = off, .row = i, .column = c};
    }
  }
  return worst;
}

}  // namespace

std::vector<Warning> warnings(const SolvedRun& run, bool check) {
  std::vector<Warning> found;
  const auto add = [&found](Finding finding, const std::optional<std::string>& text) {
    if (text) found.push_back({finding, *text});
  };
  add(Finding::feature, short_feature(run.problem, run.grid));
  ComparedSteps compared = compare_with_other_steps(run);
  if (check && compared.agreement != Agreement::differs) {
    const auto half = compare_with_half_the_steps(run);
    if (half.agreement == Agreement::differs) compared = half;
  }
  if (compared.agreement == Agreement::agrees) {
    add(Finding::oscillation, lost_oscillation(run));
    add(Finding::oscillation, damped_oscillation(run));
    return found;
  }
  add(Finding::stability, unstable_modes(run));
  add(Finding::growth, growth_of_its_own(run));
  add(Finding::alternation, alternation(run));
  if (compared.agreement == Agreement::differs) add(Finding::other_steps, compared.numbers);
  return found;
}

std::vector<double> with_times_looked_at(const Problem& problem, const Grid& grid,
                                         std::vector<double> times) {
  if (times.empty()) return times;
  for (const auto& more : {times_compared(problem, grid), last_times(grid)})
    std::ranges::copy(more, std::back_inserter(times));
  return increasing(std::move(times));
}

std::optional<MissedAccuracy> missed_accuracy(const Tolerance& requested, const Rows& values,
                                              const OtherRun& other, bool check) {
  std::optional<MissedAccuracy> error;
  if (const auto rough = other(times(requested, looser)))
    error = largest_error(requested, values, *rough, 1.0 / (looser - 1.0));
  if (check || (error && error->times > undecided)) {
    if (const auto fine = other(times(requested, 1.0 / looser)))
      error = largest_error(requested, values, *fine, looser / (looser - 1.0));
  }
  return error && error->times > missed ? error : std::nullopt;
}

}  // namespace fde
