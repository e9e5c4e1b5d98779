// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/solved_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/measures/run_outcome.hpp"
#include "fdebench/benchmarks/observers/reaction_path.hpp"
#include "fdebench/benchmarks/observers/retained_columns.hpp"
#include "fdebench/reports/command/checkpoint_file.hpp"
#include "fdebench/schemes/diagnostics/warnings.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"
#include "fdebench/schemes/stepping/rates.hpp"

namespace fde::bench {
namespace {

// A state may be finite and its energy not: throws NumericalFailure then.
void require_finite(const Vec& values, const SolvedTable& table, const Scheme& scheme,
                    const std::optional<Grid>& grid, double t) {
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) continue;
    throw NumericalFailure(fmt::format("{}: {} not finite {}", scheme.id,
                                       table.names[static_cast<std::size_t>(i)], at_time(grid, t)));
  }
}

// Whether the columns at the printed times are all that a run has to keep: then neither reactions nor the
// field need states.
bool keeps_columns(const Scene& scene, const RequestedRun& run) {
  return run.grid && !scene.reactions && !run.stores_states && !run.options.all_solutions;
}

}  // namespace

std::vector<double> times_to_return(const Scene& scene, const RequestedRun& run) {
  const double end = scene.problem.end;
  auto times = keeps_columns(scene, run) ? std::vector{end}
                                         : with_neighbour_times(scene.reactions, run.grid, run.times, end);
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
    require_finite(values, table, run.scheme, run.grid, t);
    table.values.col(next++) << values, reactions.at(c, columns.col(c));
  }
  if (next < table.values.cols()) {
    throw std::logic_error(
        fmt::format("{} left out t = {}", run.scheme.id, table.times[static_cast<std::size_t>(next)]));
  }
  return table;
}

namespace {

// The events of a path in place of its times.
SolvedTable table_of_events(const Scene& scene, const Scheme& scheme, const Trajectory& path) {
  SolvedTable table{.names = printed_names(scene), .events = std::vector<std::string>()};
  table.values.resize(std::ssize(table.names), std::ssize(path.events));
  for (Eigen::Index c = 0; const auto& [event, t, y] : path.events) {
    const Vec values = printed_values(scene, t, columns_at(scene.outputs, t, y));
    require_finite(values, table, scheme, std::nullopt, t);
    table.times.push_back(t);
    table.events->push_back(scene.events[event].name);
    table.values.col(c++) = values;
  }
  return table;
}

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

// The cost of a run as one JSON object; docs/command.md lists the keys. Counts that are unknown are left out,
// and the grid unless graded:auto chose it. `checkpoints` may be nullptr.
std::string cost_text(const Scene& scene, const RequestedRun& run, const Cost& cost, double seconds,
                      const CheckpointFile* checkpoints) {
  nlohmann::ordered_json shown{{"seconds", seconds}};
  const auto add = [&shown](const char* key, const auto& count) {
    if (count) shown[key] = *count;
  };
  add("rhs", cost.rhs_calls);
  add("newton", cost.newton_iterations);
  if (!run.automatic_grid.empty()) shown["grid"] = run.automatic_grid;
  if (run.grid && !cost.history.empty()) shown["history"] = cost.history;
  add("history_bytes", cost.history_bytes);
  add("states", cost.components);
  if (!cost.linear_solver.empty()) shown["linear_solver"] = cost.linear_solver;
  add("start_weights", cost.starting_weights);
  add("rejected_steps", cost.rejected_steps);
  if (checkpoints != nullptr) {
    const auto& write_cost = checkpoints->write_cost();
    shown["continued"] = checkpoints->resumed();
    shown["checkpoints"] = write_cost.count;
    shown["checkpoint_bytes"] = write_cost.bytes;
    shown["checkpoint_seconds"] = write_cost.seconds;
  }
  if (run.grid)
    add("expected_rate", theoretical_rate(run.scheme, scene.problem, scene.smoothness, *run.grid, Norm::end));
  return shown.dump();
}

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

SolvedTable solved_table(const Scene& scene, const Given& given,
                         const std::function<void(const std::string&)>& say,
                         const std::function<void(const Progress&)>& show) {
  RequestedRun run = requested_run(scene, given);
  RetainedColumns kept(scene.outputs, run.times);
  const bool by_columns = keeps_columns(scene, run);
  if (by_columns) run.options.observer = [&kept](double t, In y) { kept.observe(t, y); };
  if (!run.grid) run.options.events = events_of(scene);
  run.options.output_times = times_to_return(scene, run);
  auto checkpoints = requested_checkpoint(scene, run, given, kept, say);
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

  SolvedTable table = given.has("--events") ? table_of_events(scene, run.scheme, path)
                      : by_columns          ? table_of(scene, run, path, kept.times(), kept.columns())
                                   : table_of(scene, run, path, path.times, columns_of(scene.outputs, path));
  if (run.stores_states) table.field = states_at(path, table.times);
  if (checkpoints) table.checkpoint = given.text("--checkpoint");
  if (given.has(
          "--all")) {  // with other steps the solutions are others, or in another order: nothing is compared
    add_others(table, scene, run, path.other_solutions);
  } else {
    const bool check = given.has("--check");
    table.warning = run.grid ? warning_line(scene, run, path, check)
                             : warning_line(scene, run, table, path, elapsed.count(), check);
  }
  table.ended = ended_by(scene, path);
  table.cost = cost_text(scene, run, path.cost, elapsed.count(), checkpoints ? &*checkpoints : nullptr);
  return table;
}

}  // namespace fde::bench
