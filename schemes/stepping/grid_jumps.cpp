// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/grid_jumps.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace fde {

GridJumps::GridJumps(const Problem& problem, const Grid& grid) {
  constexpr double rounding = 1e-12, beside = 16 * std::numeric_limits<double>::epsilon();
  for (const double t : problem.jump_times) {
    const double time = grid.time(grid.nearest_index(std::min(t, grid.end)));
    if (std::abs(time - t) > rounding * t || (!jumps_.empty() && jumps_.back().time == time)) continue;
    jumps_.push_back({time, std::min(time, t) * (1 - beside), std::max(time, t) * (1 + beside)});
  }
}

const GridJumps::Jump* GridJumps::at(double t) const {
  const auto found = std::ranges::lower_bound(jumps_, t, {}, &Jump::time);
  return found != jumps_.end() && found->time == t ? &*found : nullptr;
}

std::optional<double> GridJumps::before(double t) const {
  const auto* jump = at(t);
  return jump != nullptr ? std::optional(jump->before) : std::nullopt;
}

Problem GridJumps::with_means(const Problem& problem) const {
  // Of a function that writes an array of the type Result, and of one that returns a number.
  const auto mean = [&]<class Result, class Written>(std::function<void(double, In, Written)> function) {
    return [jumps = *this, function = std::move(function)](double t, In y, Written result) {
      const auto* jump = jumps.at(t);
      if (jump == nullptr) return function(t, y, result);
      function(jump->after, y, result);
      const Result after = result;
      function(jump->before, y, result);
      result = 0.5 * (result + after);
    };
  };
  const auto mean_number = [&](std::function<double(double, In)> function) {
    return [jumps = *this, function = std::move(function)](double t, In y) {
      const auto* jump = jumps.at(t);
      return jump == nullptr ? function(t, y) : 0.5 * (function(jump->before, y) + function(jump->after, y));
    };
  };
  Problem means = problem;
  means.rhs = mean.operator()<Vec>(problem.rhs);
  if (const auto* dense = std::get_if<DenseJacobian>(&problem.derivatives))
    means.derivatives = DenseJacobian{mean.operator()<Matrix>(dense->at)};
  if (const auto* sparse = std::get_if<SparseJacobian>(&problem.derivatives))
    means.derivatives = SparseJacobian{mean.operator()<SparseMatrix>(sparse->at)};
  for (auto& equation : means.equations) {
    equation.force = mean_number(equation.force);
    equation.factor = mean_number(equation.factor);
  }
  return means;
}

}  // namespace fde
