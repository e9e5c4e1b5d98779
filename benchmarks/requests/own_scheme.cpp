// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/own_scheme.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <stdexcept>
#include <utility>

namespace fde::bench {
namespace {

std::vector<double> times_of(const Grid& grid) {
  std::vector<double> times;
  for (int n = 0; n <= grid.steps; ++n) times.push_back(grid.time(n));
  return times;
}

void require_shape(std::string_view id, const Rows& y, Eigen::Index components, std::size_t times) {
  if (y.rows() == components && static_cast<std::size_t>(y.cols()) == times) return;
  throw std::invalid_argument(
      fmt::format("scheme {}: returned {} x {} states, must be {} components x {} times", id, y.rows(),
                  y.cols(), components, times));
}

// The requested ones of the states up to the first that is not finite.
Trajectory path_of(const std::vector<double>& times, const Rows& y, const Options& options) {
  Trajectory path;
  std::vector<Eigen::Index> kept;
  for (Eigen::Index c = 0; c < y.cols(); ++c) {
    const double t = times[static_cast<std::size_t>(c)];
    if (!y.col(c).allFinite()) {
      path.status = SolveStatus::non_finite;
      path.failure_time = t;
      break;
    }
    if (options.observer) options.observer(t, y.col(c));
    path.last_time = t;
    path.steps = c;
    const auto next = kept.size();
    if (!options.output_times.empty() &&
        (next == options.output_times.size() || options.output_times[next] != t))
      continue;
    kept.push_back(c);
    path.times.push_back(t);
  }
  path.y = y(Eigen::all, kept);
  return path;
}

}  // namespace

OwnScheme::OwnScheme(std::string id, StatesOfRun states, const Capabilities& capabilities)
    : id_(std::move(id)),
      scheme_{.id = id_,
              .title = id_,
              .source = "the caller",
              .capabilities = capabilities,
              .solve = on_grid([this, states = std::move(states)](const Problem& problem, const Grid& grid,
                                                                  const Options& options) {
                const auto times = times_of(grid);
                const Rows y = states(problem, times);
                require_shape(id_, y, problem.size(), times.size());
                return path_of(times, y, options);
              })} {}

}  // namespace fde::bench
