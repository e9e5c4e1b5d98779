// SPDX-License-Identifier: MIT
#include "fdebench/reference/two_sided/nodal_solution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "fdebench/schemes/problem/initial_guess.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::reference {
namespace {

constexpr std::size_t most_iterations = 60;
constexpr int most_halvings = 20;
constexpr double rounding = 1e-13, small = 1e-9;

// Damped Newton step: adds the increment, or the largest of its half, quarter, ... that decreases the
// residual. Returns the size of the full increment, since damped iterations have not converged. Small
// increments are always added in full: their effect on the residual is rounding.
double damped_newton_step(const NodalEquations& equations, NodalValues& values) {
  const NodalResidual residual = equations.residual(values);
  const NodalValues increment = equations.increment(values, residual);
  const double size = increment.size();
  const bool last = size <= small * std::max(1.0, values.size());
  double part = 1.0;
  for (int halving = 0; halving < most_halvings; ++halving, part /= 2) {
    NodalValues trial{values.y + part * increment.y, values.unknown + part * increment.unknown};
    const double after = equations.residual(trial).norm();
    if (!(after < residual.norm() || (last && std::isfinite(after)))) continue;
    values = std::move(trial);
    return size;
  }
  throw std::runtime_error("two-sided reference: Newton's method finds no way down");
}

NodalValues first_iterate(const NodalEquations& equations, const NodalBasis& basis,
                          const std::function<Vec(RelativeTime t)>& start) {
  NodalValues values = equations.start();
  if (!start) return values;
  for (std::size_t m = 0; m < basis.nodes.size(); ++m)
    values.y.row(static_cast<Eigen::Index>(m)) = start(basis.nodes[m]).transpose();
  return values;
}

NodalValues solved(const NodalEquations& equations, NodalValues values) {
  double before = std::numeric_limits<double>::infinity();
  for (std::size_t iteration = 0; iteration < most_iterations; ++iteration) {
    report_progress(iteration);
    const double moved = damped_newton_step(equations, values), size = std::max(1.0, values.size());
    if (moved <= rounding * size || (moved >= before / 2 && moved <= 1e3 * rounding * size)) return values;
    before = moved;
  }
  throw std::runtime_error("two-sided reference: Newton's method does not converge");
}

}  // namespace

NodalSolution::NodalSolution(const Problem& problem, const NodalBasis& basis,
                             const std::function<Vec(RelativeTime t)>& start)
    : equations_(problem, basis),
      values_(solved(equations_, first_iterate(equations_, basis, start))),
      f_(equations_.rhs(values_.y)) {}

NodalSolution smallest_solution(const Problem& problem, const NodalBasis& basis) {
  constexpr int starts = 64, times = 64;
  std::optional<NodalSolution> smallest;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& start : initial_guesses(problem, starts)) {
    try {
      NodalSolution found(problem, basis,
                          [&](RelativeTime t) { return start.at(problem.end * t.from_start); });
      double size = 0.0;
      for (int n = 0; n <= times; ++n) {
        const double share = static_cast<double>(n) / times;
        size += found.at({share, 1.0 - share}).squaredNorm();
      }
      if (!(size < least)) continue;
      least = size;
      smallest.emplace(std::move(found));
    } catch (const std::runtime_error&) {
      continue;  // no convergence from these initial values
    }
  }
  if (!smallest) throw std::runtime_error("two-sided reference: no start of Newton's method converges");
  return std::move(*smallest);
}

}  // namespace fde::reference
