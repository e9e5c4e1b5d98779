// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/interpolated_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fde::bench {

InterpolatedRun::InterpolatedRun(const Scene& scene, const Configuration& configuration, int steps,
                                 double budget)
    : grid_{.end = scene.problem.end, .steps = steps, .grading = configuration.grading} {
  const auto path = configuration.scheme->solve(scene.problem, grid_, {.budget = budget});
  if (path.status != SolveStatus::finished) return;
  Rows columns = columns_of(scene.outputs, path);
  if (columns.allFinite()) columns_ = std::move(columns);
}

Vec InterpolatedRun::at(double t) const {
  constexpr int nodes = 4;
  const double n = grid_.steps * std::pow(t / grid_.end, 1.0 / grid_.grading);
  const int first = std::clamp(static_cast<int>(std::floor(n)) - 1, 0, grid_.steps + 1 - nodes);
  Vec value = Vec::Zero(columns_.rows());
  for (int i = 0; i < nodes; ++i) {
    double weight = 1.0;
    for (int k = 0; k < nodes; ++k) {
      if (k != i) weight *= (n - first - k) / (i - k);
    }
    value += weight * columns_.col(first + i);
  }
  return value;
}

Rows InterpolatedRun::at(const std::vector<double>& times) const {
  Rows values(columns_.rows(), std::ssize(times));
  for (std::size_t c = 0; c < times.size(); ++c) values.col(static_cast<Eigen::Index>(c)) = at(times[c]);
  return values;
}

}  // namespace fde::bench
