// SPDX-License-Identifier: MIT
#include "fdebench/schemes/diagnostics/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "fdebench/schemes/diagnostics/damped_oscillation.hpp"
#include "fdebench/schemes/diagnostics/modes.hpp"
#include "fdebench/schemes/diagnostics/stored_path.hpp"

namespace fde {
namespace {

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
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace fde
