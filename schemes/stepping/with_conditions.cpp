// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/with_conditions.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "fdebench/schemes/problem/shooting.hpp"
#include "fdebench/schemes/stepping/run.hpp"

namespace fde {
namespace {

// The runs of a scheme that look for the missing values: nothing of them is wanted but their end.
class Probes {
 public:
  Probes(const Solve& solve, const Options& options) : solve_(solve), options_(options) {}

  std::optional<Vec> end(const Problem& problem, const Resolution& resolution) {
    const Options wanted{.history = options_.history,
                         .corrections = options_.corrections,
                         .newton_tolerance = options_.newton_tolerance,
                         .budget = budget(),
                         .threads = options_.threads,
                         .output_times = {problem.end}};
    if (wanted.budget <= 0.0) return std::nullopt;
    const Trajectory path = solve_(problem, resolution, wanted);
    add(path.cost.rhs_calls, rhs_calls_);
    add(path.cost.newton_iterations, newton_iterations_);
    add(path.cost.rejected_steps, rejected_steps_);
    if (path.status != SolveStatus::finished || path.times.empty()) return std::nullopt;
    return Vec(path.y.rightCols<1>());
  }

  // What is left of the budget.
  [[nodiscard]] double budget() const {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin_;
    return std::max(options_.budget - taken.count(), 0.0);
  }

  void add_costs(Cost& to) const {
    add(rhs_calls_, to.rhs_calls);
    add(newton_iterations_, to.newton_iterations);
    add(rejected_steps_, to.rejected_steps);
  }

 private:
  using Count = std::optional<std::int64_t>;
  static void add(const Count& count, Count& to) {
    if (count) to = to.value_or(0) + *count;
  }

  const Solve& solve_;
  const Options& options_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  Count rhs_calls_{}, newton_iterations_{}, rejected_steps_{};
};

// The part of y(end) that is no smooth function of the initial values.
Tolerance noise_of(const Resolution& resolution, const Options& options) {
  const auto* tolerance = std::get_if<Tolerance>(&resolution);
  return tolerance == nullptr ? Tolerance{options.newton_tolerance, 0.0} : *tolerance;
}

// A grid that every scheme takes which takes this one; a tolerance that is not below rounding.
Resolution other_resolution(const Resolution& resolution) {
  constexpr double looser = 16.0;
  if (const auto* grid = std::get_if<Grid>(&resolution)) {
    constexpr int most = std::numeric_limits<int>::max() / 2;
    return Grid{grid->end, grid->steps > most ? grid->steps / 2 : 2 * grid->steps, grid->grading};
  }
  const auto& [rtol, atol] = std::get<Tolerance>(resolution);
  return Tolerance{looser * rtol, looser * atol};
}

Trajectory shoot(const Problem& problem, const Resolution& resolution, const Options& options,
                 const Solve& solve) {
  Probes probes(solve, options);
  const auto run_with = [&](const Resolution& used) {
    return [&probes, used](const Problem& complete) { return probes.end(complete, used); };
  };
  const auto found = find_missing_values(problem, run_with(resolution), noise_of(resolution, options));
  const Problem complete = with_initial_values(problem, found.values);
  const bool is_known =
      found.converged && are_determined(problem, found, run_with(other_resolution(resolution)));
  Trajectory path;
  if (is_known || !std::isfinite(found.missed) || probes.budget() <= 0.0) {
    Options last = options;
    last.budget = probes.budget();
    path = solve(complete, resolution, last);
  } else {
    path = Run(complete, options).finish();
    path.status = found.converged ? SolveStatus::undetermined : SolveStatus::not_converged;
    path.residual = found.missed;
  }
  probes.add_costs(path.cost);
  return path;
}

}  // namespace

Solve with_conditions(Solve solve) {
  return [solve = std::move(solve)](const Problem& problem, const Resolution& resolution,
                                    const Options& options) {
    if (!is_solved_by_shooting(problem)) return solve(problem, resolution, options);
    return shoot(problem, resolution, options, solve);
  };
}

}  // namespace fde
