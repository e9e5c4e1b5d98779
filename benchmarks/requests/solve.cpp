// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/solve.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <memory>
#include <thread>
#include <utility>

#include "fdebench/benchmarks/measures/run_outcome.hpp"
#include "fdebench/benchmarks/observers/retained_columns.hpp"
#include "fdebench/benchmarks/requests/checkpoint_file.hpp"
#include "fdebench/benchmarks/requests/run_table.hpp"
#include "fdebench/benchmarks/requests/run_warnings.hpp"
#include "fdebench/benchmarks/scenes/start_time.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"
#include "fdebench/schemes/stepping/rates.hpp"

namespace fde::bench {
namespace {

// Appends the rows of other solutions, and numbers all.
void add_others(SolvedTable& table, const Scene& scene, const RequestedRun& run,
                const std::vector<Trajectory>& others) {
  table.solutions.emplace(table.times.size(), 1);
  for (const auto& path : others) {
    if (path.status != SolveStatus::finished) continue;
    const SolvedTable other = table_of(scene, run, path, path.times, columns_of(scene.outputs, path));
    table.solutions->insert(table.solutions->end(), other.times.size(), table.solutions->back() + 1);
    table.times.insert(table.times.end(), other.times.begin(), other.times.end());
    const Matrix before = std::move(table.values);
    table.values.resize(before.rows(), before.cols() + other.values.cols());
    table.values << before, other.values;
  }
}

std::string ended_by(const Scene& scene, const Trajectory& path) {
  if (path.status != SolveStatus::terminal_event) return "";
  return fmt::format("event {} ended the run at t = {:.17g}", scene.events[path.events.back().event].name,
                     from_zero(scene, path.last_time));
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

// What the run took. `checkpoints` may be nullptr.
SolveCost cost_of(const Scene& scene, const SolveRequest& request, const RequestedRun& run, const Cost& cost,
                  double seconds, const CheckpointFile* checkpoints) {
  SolveCost taken{.seconds = seconds, .of_scheme = cost};
  if (request.optimal_grading) taken.grid = grid_text(run.settings.grading);
  if (!run.grid) taken.of_scheme.history = {};
  if (checkpoints != nullptr) taken.checkpoints = checkpoints->cost();
  if (run.grid) {
    taken.expected_rate = theoretical_rate(run.scheme, scene.problem, scene.smoothness, *run.grid, Norm::end);
  }
  return taken;
}

bool came_through(const Trajectory& path) {
  return path.status == SolveStatus::finished || path.status == SolveStatus::terminal_event;
}

// What a run that did not finish says.
RunFailure failure_of(const Scene& scene, const Scheme& scheme, const Trajectory& path) {
  const auto what = fmt::format("{}: {}", scheme.id, describe(scene.problem, path));
  RunFailure failure(with_note_of_start(scene, what), scheme.id, path);
  if (failure.time) failure.time = from_zero(scene, *failure.time);
  return failure;
}

// The run until its end. Removes its checkpoint and throws RunFailure where it does not come there, unless
// more time would bring it there.
Trajectory finished(const Scene& scene, const RequestedRun& run, const CheckpointFile* checkpoints) {
  Trajectory path = run.scheme.solve(scene.problem, run.resolution, run.options);
  if (came_through(path)) return path;
  if (checkpoints != nullptr && path.status != SolveStatus::out_of_budget) checkpoints->remove();
  throw failure_of(scene, run.scheme, path);
}

// The times of a table as users read them.
void count_from_zero(SolvedTable& table, const Scene& scene) {
  for (double& t : table.times) t = from_zero(scene, t);
  for (auto& warning : table.warnings) warning.text = with_note_of_start(scene, warning.text);
}

}  // namespace

std::string warning_text(const std::vector<Warning>& warnings) {
  std::vector<std::string_view> texts;
  for (const auto& warning : warnings) texts.emplace_back(warning.text);
  return fmt::format("{}", fmt::join(texts, "; "));
}

SolvedTable solve(const Scene& scene, const SolveRequest& request, const SolveListener& listener) {
  RequestedRun run = requested_run(scene, request);
  RetainedColumns kept(scene.outputs, run.times);
  if (run.keeps_columns) run.options.observer = [&kept](double t, In y) { kept.observe(t, y); };
  if (!run.grid) run.options.events = events_of(scene);
  run.options.output_times = times_to_return(scene, run);
  auto checkpoints = requested_checkpoint(scene, request, run, kept, listener.complain);
  if (checkpoints) run.options.checkpoints = &*checkpoints;

  std::optional<ProgressScope> listening;
  if (listener.progress) listening.emplace(shown_steps(scene, run, listener.progress));
  std::jthread beside;
  if (listener.quicker) beside = quicker_scheme_search(scene, run, listener.long_run, listener.quicker);
  const auto start = std::chrono::steady_clock::now();
  Trajectory path = finished(scene, run, checkpoints ? &*checkpoints : nullptr);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  beside = {};
  listening.reset();
  if (listener.progress) listener.progress({.current_run = "checks the result"});
  solve_beside_its_times(scene, run, path);
  std::erase_if(run.times,
                [&](double t) { return path.status == SolveStatus::terminal_event && t > path.last_time; });

  SolvedTable table = request.events ? table_of_events(scene, run.scheme, path)
                      : run.keeps_columns
                          ? table_of(scene, run, path, kept.times(), kept.columns())
                          : table_of(scene, run, path, path.times, columns_of(scene.outputs, path));
  if (request.field) table.field = states_at(path, table.times);
  if (checkpoints) table.checkpoint = request.checkpoint->file;
  if (request.all_solutions) {  // with other steps they are others, or in another order: nothing is compared
    add_others(table, scene, run, path.other_solutions);
  } else {
    table.warnings = run.grid ? run_warnings(scene, run, path, request.check)
                              : run_warnings(scene, run, table, path, elapsed.count(), request.check);
  }
  count_from_zero(table, scene);
  table.ended = ended_by(scene, path);
  table.cost =
      cost_of(scene, request, run, path.cost, elapsed.count(), checkpoints ? &*checkpoints : nullptr);
  return table;
}

}  // namespace fde::bench
