// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/with_delays.hpp"

#include <fmt/format.h>

#include <iterator>
#include <utility>
#include <variant>

#include "fdebench/schemes/problem/delays.hpp"

namespace fde {

std::optional<std::string> unsupported_delays_reason(const Scheme& scheme, const Problem& problem,
                                                     const Resolution& resolution) {
  if (problem.delays.lags.empty()) return std::nullopt;
  if (scheme.capabilities.discretises_equations) return "takes no delays";
  if (has_right_rows(problem)) return "takes no delays in a problem that it solves at all times at once";
  const double lag = problem.delays.lags.front();
  const auto* grid = std::get_if<Grid>(&resolution);
  if (grid == nullptr) {
    constexpr double shortest = 1e-5;  // of the end: no step is longer
    if (lag >= shortest * problem.end) return std::nullopt;
    return fmt::format("takes delays from {} of the end on, the shortest is {}", shortest, lag);
  }
  // Starting weights take as many steps at once.
  const auto at_once = scheme.starting_powers ? std::ssize(scheme.starting_powers(problem)) : 1;
  const double longest = grid->step(grid->steps);
  constexpr double rounding = 1e-12;
  if (static_cast<double>(at_once) * longest <= lag * (1.0 + rounding)) return std::nullopt;
  return fmt::format("needs {} in the shortest delay, {}, and not steps of {:.6g}",
                     at_once == 1 ? "a step" : fmt::format("{} steps", at_once), lag, longest);
}

Solve with_delays(Solve solve) {
  return [solve = std::move(solve)](const Problem& problem, const Resolution& resolution,
                                    const Options& options) {
    if (problem.delays.lags.empty()) return solve(problem, resolution, options);
    BoundProblem bound(problem);
    Options inner = options;
    inner.wants_past = [&](const Past& solution) {
      bound.set_solution(solution);
      if (options.wants_past) options.wants_past(solution);
    };
    return solve(bound.problem(), resolution, inner);
  };
}

}  // namespace fde
