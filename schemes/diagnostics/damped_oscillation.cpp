// SPDX-License-Identifier: MIT
#include "fdebench/schemes/diagnostics/damped_oscillation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "fdebench/schemes/diagnostics/modes.hpp"
#include "fdebench/schemes/diagnostics/stored_path.hpp"

namespace fde {

std::optional<std::string> damped_oscillation(const SolvedRun& run) {
  constexpr double many_times = 2.0;
  const Scheme& undamped = *find_scheme("product_trapezoidal");
  const auto& components = run.problem.components;
  if (&run.scheme == &undamped || is_two_sided(run.problem) ||
      run.problem.size() * run.grid.steps > longest_settled)
    return std::nullopt;
  if (std::ranges::none_of(components, is_algebraic) && !may_damp_oscillation(run)) return std::nullopt;
  auto times = late_times(run.grid);
  std::ranges::copy(spread_times(run.grid), std::back_inserter(times));
  std::ranges::sort(times);
  const auto path = solve_again(run, undamped, run.grid, times);
  if (path.status != SolveStatus::finished) return std::nullopt;
  const Vec here = late_sizes(run);
  const Vec there = late_sizes({undamped, run.problem, run.grid, run.options, path, {}, run.functions});
  for (Eigen::Index i = 0; i < here.size(); ++i) {
    if ((i < run.problem.size() && is_algebraic(components[static_cast<std::size_t>(i)])) ||
        there[i] <= many_times * here[i])
      continue;
    return fmt::format("in the last quarter {} is up to {:.3g}, and {:.3g} with {} on the same grid",
                       run.name(i), here[i], there[i], undamped.id);
  }
  return std::nullopt;
}

}  // namespace fde
