// SPDX-License-Identifier: MIT
#include "fdebench/schemes/diagnostics/damped_oscillation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "fdebench/schemes/diagnostics/modes.hpp"
#include "fdebench/schemes/diagnostics/stored_path.hpp"

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

}  // namespace

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

}  // namespace fde
