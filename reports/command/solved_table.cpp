// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/solved_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/measures/run_outcome.hpp"
#include "fdebench/benchmarks/observers/retained_columns.hpp"
#include "fdebench/reports/command/cost_text.hpp"
#include "fdebench/reports/command/requested_checkpoint.hpp"
#include "fdebench/reports/command/run_warnings.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::bench {
namespace {

std::string ended_by(const Scene& scene, const Trajectory& path) {
  if (path.status != SolveStatus::terminal_event) return "";
  return fmt::format("event {} ended the run at t = {:.17g}", scene.events[path.events.back().event].name,
                     path.last_time);
}

// The states of a path at some of its times.
Rows states_at(const Trajectory& path, const std::vector<double>& times) {
  Rows states(path.y.rows(), std::ssize(times));
  Eigen::Index next = 0;
  for (Eigen::Index c = 0; c < path.y.cols() && next < states.cols(); ++c) {
    if (path.times[static_cast<std::size_t>(c)] == times[static_cast<std::size_t>(next)])
      states.col(next++) = path.y.col(c);
  }
  return states.leftCols(next);
}

// The times that a scheme chooses are known at the end: a second run stores the times beside them, which
// reactions need.
void solve_beside_its_times(const Scene& scene, RequestedRun& run, Trajectory& path) {
  if (run.grid || !run.times.empty() || scene.reactions.differentiated_columns.empty() ||
      path.status != SolveStatus::finished)
    return;
  run.times = path.times;
  run.options.output_times = times_to_return(scene, run);
  run.options.checkpoints = nullptr;
  path = run.scheme.solve(scene.problem, run.resolution, run.options);
}

// Passes on how much of a run is done: over a grid the part of its work, which for direct sums grows with the
// square of the step, otherwise the part of the time interval.
ProgressCallback shown_steps(const Scene& scene, RequestedRun& run,
                             const std::function<void(const Progress&)>& show) {
  const std::string what(run.scheme.id);
  if (run.grid) {
    const auto total = static_cast<std::size_t>(run.grid->steps);
    const bool squared = run.options.history == HistoryKind::direct;
    return [=](std::size_t done, std::size_t) {
      const double part = static_cast<double>(std::min(done, total)) / static_cast<double>(total);
      if (done > 0)
        show({.part = squared ? part * part : part, .done = done, .total = total, .current_run = what});
    };
  }
  const auto reached = std::make_shared<double>(0.0);
  run.options.observer = [reached, observer = run.options.observer](double t, In y) {
    *reached = t;
    if (observer) observer(t, y);
  };
  return [=, end = scene.problem.end](std::size_t, std::size_t) {
    show({.part = *reached / end, .current_run = what});
  };
}

}  // namespace

SolvedTable solved_table(const Scene& scene, const RunArguments& arguments,
                         const std::function<void(const std::string&)>& say,
                         const std::function<void(const Progress&)>& show) {
  RequestedRun run = requested_run(scene, arguments);
  RetainedColumns kept(scene.outputs, run.times);
  const bool by_columns = keeps_columns(scene, run);
  if (by_columns) run.options.observer = [&kept](double t, In y) { kept.observe(t, y); };
  if (!run.grid) run.options.events = events_of(scene);
  run.options.output_times = times_to_return(scene, run);
  auto checkpoints = requested_checkpoint(scene, run, arguments, kept, say);
  if (checkpoints) run.options.checkpoints = &*checkpoints;

  std::optional<ProgressScope> listening;
  if (show) listening.emplace(shown_steps(scene, run, show));
  const auto start = std::chrono::steady_clock::now();
  Trajectory path = run.scheme.solve(scene.problem, run.resolution, run.options);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  listening.reset();
  if (show) show({.current_run = "checks the result"});
  solve_beside_its_times(scene, run, path);
  const bool came_through =
      path.status == SolveStatus::finished || path.status == SolveStatus::terminal_event;
  if (checkpoints && !came_through && path.status != SolveStatus::out_of_budget) checkpoints->remove();
  if (!came_through) {
    const auto text = fmt::format("{}: {}", run.scheme.id, describe(scene.problem, path));
    throw RunFailure(text, run.scheme.id, path);
  }
  std::erase_if(run.times,
                [&](double t) { return path.status == SolveStatus::terminal_event && t > path.last_time; });

  SolvedTable table = arguments.events ? table_of_events(scene, run.scheme, path)
                      : by_columns     ? table_of(scene, run, path, kept.times(), kept.columns())
                                   : table_of(scene, run, path, path.times, columns_of(scene.outputs, path));
  if (run.stores_states) table.field = states_at(path, table.times);
  if (checkpoints) table.checkpoint = *arguments.checkpoint;
  if (arguments.all) {  // with other steps the solutions are others, or in another order: nothing is compared
    add_others(table, scene, run, path.other_solutions);
  } else {
    table.warning = run.grid ? warning_line(scene, run, path, arguments.check)
                             : warning_line(scene, run, table, path, elapsed.count(), arguments.check);
  }
  table.ended = ended_by(scene, path);
  table.cost = cost_text(scene, run, path.cost, elapsed.count(), checkpoints ? &*checkpoints : nullptr);
  return table;
}

}  // namespace fde::bench
