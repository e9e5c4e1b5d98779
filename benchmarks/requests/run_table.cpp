// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/run_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "fdebench/benchmarks/measures/run_outcome.hpp"
#include "fdebench/benchmarks/observers/reaction_path.hpp"
#include "fdebench/benchmarks/scenes/start_time.hpp"
#include "fdebench/schemes/diagnostics/warnings.hpp"

namespace fde::bench {
namespace {

// A state may be finite and its energy not: throws NumericalFailure then.
void require_finite(const Scene& scene, const Vec& values, const SolvedTable& table, const Scheme& scheme,
                    const std::optional<Grid>& grid, double t) {
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i]) || !is_regular(scene, t, i)) continue;
    throw NumericalFailure(
        with_note_of_start(scene, fmt::format("{}: {} not finite {}", scheme.id,
                                              table.names[static_cast<std::size_t>(i)], at_time(grid, t))));
  }
}

}  // namespace

std::vector<double> times_to_return(const Scene& scene, const RequestedRun& run) {
  const double end = scene.problem.end;
  auto times =
      run.keeps_columns ? std::vector{end} : with_neighbour_times(scene.reactions, run.grid, run.times, end);
  return run.grid ? with_times_looked_at(scene.problem, *run.grid, times) : times;
}

SolvedTable table_of(const Scene& scene, const RequestedRun& run, const Trajectory& path,
                     const std::vector<double>& times, const Rows& columns) {
  const ReactionPath reactions(scene, run.grid, path);
  SolvedTable table{.names = printed_names(scene), .times = run.times.empty() ? times : run.times};
  const auto of_reactions = reactions.names();
  table.names.insert(table.names.end(), of_reactions.begin(), of_reactions.end());
  table.values.resize(std::ssize(table.names), std::ssize(table.times));
  Eigen::Index next = 0;
  for (Eigen::Index c = 0; c < columns.cols() && next < table.values.cols(); ++c) {
    const double t = times[static_cast<std::size_t>(c)];
    if (t != table.times[static_cast<std::size_t>(next)]) continue;
    const Vec values = printed_values(scene, t, columns.col(c));
    require_finite(scene, values, table, run.scheme, run.grid, t);
    table.values.col(next++) << values, reactions.at(c, columns.col(c));
  }
  if (next < table.values.cols()) {
    throw std::logic_error(
        fmt::format("{} left out t = {}", run.scheme.id, table.times[static_cast<std::size_t>(next)]));
  }
  return table;
}

SolvedTable table_of_events(const Scene& scene, const Scheme& scheme, const Trajectory& path) {
  SolvedTable table{.names = printed_names(scene), .events = std::vector<std::string>()};
  table.values.resize(std::ssize(table.names), std::ssize(path.events));
  for (Eigen::Index c = 0; const auto& [event, t, y] : path.events) {
    const Vec values = printed_values(scene, t, columns_at(scene.outputs, t, y));
    require_finite(scene, values, table, scheme, std::nullopt, t);
    table.times.push_back(t);
    table.events->push_back(scene.events[event].name);
    table.values.col(c++) = values;
  }
  return table;
}

}  // namespace fde::bench
