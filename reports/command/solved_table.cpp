#include "command/solved_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "command/asked_checkpoint.hpp"
#include "command/cost_text.hpp"
#include "measures/ending.hpp"
#include "observers/kept_columns.hpp"
#include "observers/reaction_path.hpp"
#include "trust/missed_accuracy.hpp"
#include "trust/warnings.hpp"

namespace fde {
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

// Of the columns at times of a run, which are those of the path where it has states that tell reactions.
SolvedTable table_of(const Scene& scene, const AskedRun& run, const Trajectory& path,
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

// The column that shows a component as it is, "" where none does: seen where all components differ.
std::vector<std::string> columns_of_components(const Scene& scene) {
  const Vec y = Vec::LinSpaced(scene.problem.size(), 0.1, 0.7);
  const Vec columns = columns_at(scene.outputs, 0.0, y);
  std::vector<std::string> names(static_cast<std::size_t>(y.size()));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto shown = std::ranges::find(columns, y[static_cast<Eigen::Index>(i)]);
    if (shown != columns.end())
      names[i] = scene.outputs.names[static_cast<std::size_t>(shown - columns.begin())];
  }
  return names;
}

// Appends the rows of other solutions, and numbers all.
void add_others(SolvedTable& table, const Scene& scene, const AskedRun& run,
                const std::vector<Trajectory>& others) {
  table.solutions.emplace(table.times.size(), 1);
  for (const auto& path : others) {
    if (path.ending != Ending::finished) continue;
    const SolvedTable other = table_of(scene, run, path, path.times, columns_of(scene.outputs, path));
    table.solutions->insert(table.solutions->end(), other.times.size(), table.solutions->back() + 1);
    table.times.insert(table.times.end(), other.times.begin(), other.times.end());
    const Matrix before = std::move(table.values);
    table.values.resize(before.rows(), before.cols() + other.values.cols());
    table.values << before, other.values;
  }
}

// The events in place of the times of the path.
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

std::string ended_by(const Scene& scene, const Trajectory& path) {
  if (path.ending != Ending::event) return "";
  return fmt::format("event {} ended the run at t = {:.17g}", scene.events[path.events.back().event].name,
                     path.reached);
}

std::string as_warning(const std::vector<std::string>& texts) {
  return texts.empty() ? "" : fmt::format("warning: {}", fmt::join(texts, "; "));
}

// One line of all that speaks against the numbers of a run over a grid; empty: nothing.
std::string warning_line(const Scene& scene, const AskedRun& run, const Trajectory& path, bool check) {
  std::vector<std::string> texts;
  for (const auto& event : scene.events) {
    if (!event.ends) continue;
    texts.push_back(fmt::format("event {} does not end this run: {} steps over a grid and locates none",
                                event.name, run.scheme.id));
  }
  const SolvedRun solved{run.scheme,  scene.problem, *run.grid,
                         run.options, path,          columns_of_components(scene)};
  for (const Warning& warning : warnings(solved, check)) texts.push_back(warning.text);
  return as_warning(texts);
}

// Without reactions columns are all there is to keep, and the states that warnings look at.
bool keeps_columns(const Scene& scene, const AskedRun& run) {
  return run.grid && !scene.reactions && !run.keeps_states && !run.options.all_solutions;
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

// The times at which states are returned.
std::vector<double> times_to_return(const Scene& scene, const AskedRun& run) {
  const double end = scene.problem.end;
  auto times = keeps_columns(scene, run) ? std::vector{end}
                                         : with_times_beside(scene.reactions, run.grid, run.times, end);
  return run.grid ? with_times_looked_at(scene.problem, *run.grid, times) : times;
}

// Some of the columns, spread evenly over them, the last one among them.
std::vector<Eigen::Index> spread_columns(Eigen::Index count) {
  constexpr Eigen::Index most = 32;
  std::vector<Eigen::Index> columns;
  for (Eigen::Index k = 1; k <= std::min(count, most); ++k)
    columns.push_back(k * count / std::min(count, most) - 1);
  return columns;
}

// Of a run that has chosen its steps and took so many seconds: what runs to other accuracies say against what
// is printed. Each may take four times as long.
std::optional<std::string> accuracy_warning(const Scene& scene, const AskedRun& run, const SolvedTable& table,
                                            const Trajectory& path, double seconds, bool check) {
  constexpr double most_times = 4.0, least_seconds = 0.05;
  if (table.times.empty()) return std::nullopt;
  const auto columns = spread_columns(std::ssize(table.times));
  AskedRun other = run;
  other.times.clear();
  for (const auto c : columns) other.times.push_back(table.times[static_cast<std::size_t>(c)]);
  other.options.events.clear();
  other.options.checkpoints = nullptr;
  other.options.budget = std::max(most_times * seconds, least_seconds);
  other.options.at = times_to_return(scene, other);
  Problem problem = scene.problem;
  if (path.ending == Ending::event) problem.end = other.options.at.back();
  const auto values = [&](const Accuracy& asked) -> std::optional<Rows> {
    const auto solved = run.scheme.solve(problem, asked, other.options);
    if (solved.ending != Ending::finished) return std::nullopt;
    try {
      return table_of(scene, other, solved, solved.times, columns_of(scene.outputs, solved)).values;
    } catch (const NumericalFailure&) {
      return std::nullopt;
    }
  };
  const auto accuracy = std::get<Accuracy>(run.resolution);
  const auto missed = missed_accuracy(accuracy, table.values(Eigen::all, columns), values, check);
  if (!missed) return std::nullopt;
  return fmt::format("{} at t = {:.6g} is off by about {:.2g} times the accuracy that is asked",
                     table.names[static_cast<std::size_t>(missed->row)],
                     other.times[static_cast<std::size_t>(missed->column)], missed->times);
}

// The same of a run that has chosen its steps: an accuracy that no double has, one that is not delivered, and
// the events whose functions are a number at no time.
std::string warning_line(const Scene& scene, const AskedRun& run, const SolvedTable& table,
                         const Trajectory& path, double seconds, bool check) {
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  const auto accuracy = std::get<Accuracy>(run.resolution);
  std::vector<std::string> texts;
  if (accuracy.relative < rounding) {
    texts.push_back(
        fmt::format("an accuracy of {:.3g} is asked, and a double has {:.2g}", accuracy.relative, rounding));
  } else if (const auto missed = accuracy_warning(scene, run, table, path, seconds, check)) {
    texts.push_back(*missed);
  }
  const Rows columns = columns_of(scene.outputs, path);
  for (const auto& event : scene.events) {
    bool is_number = columns.cols() == 0;
    for (Eigen::Index c = 0; c < columns.cols() && !is_number; ++c)
      is_number = !std::isnan(event.value(path.time(c), columns.col(c)));
    if (!is_number)
      texts.push_back(fmt::format("event {} is not a number at any time of the run", event.name));
  }
  return as_warning(texts);
}

// Which times a scheme chooses it says at the end: then it is asked for those beside them, which reactions
// need.
void solve_beside_its_times(const Scene& scene, AskedRun& run, Trajectory& path) {
  if (run.grid || !run.times.empty() || scene.reactions.rated.empty() || path.ending != Ending::finished)
    return;
  run.times = path.times;
  run.options.at = times_to_return(scene, run);
  run.options.checkpoints = nullptr;
  path = run.scheme.solve(scene.problem, run.resolution, run.options);
}

}  // namespace

SolvedTable solved_table(const Scene& scene, const RunArguments& arguments,
                         const std::function<void(const std::string&)>& say) {
  AskedRun run = asked_run(scene, arguments);
  KeptColumns kept(scene.outputs, run.times);
  const bool by_columns = keeps_columns(scene, run);
  if (by_columns) run.options.observer = [&kept](double t, In y) { kept.observe(t, y); };
  if (!run.grid) run.options.events = events_of(scene);
  run.options.at = times_to_return(scene, run);
  auto checkpoints = asked_checkpoint(scene, run, arguments, kept, say);
  if (checkpoints) run.options.checkpoints = &*checkpoints;

  const auto start = std::chrono::steady_clock::now();
  Trajectory path = run.scheme.solve(scene.problem, run.resolution, run.options);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  solve_beside_its_times(scene, run, path);
  const bool came_through = path.ending == Ending::finished || path.ending == Ending::event;
  if (checkpoints && !came_through && path.ending != Ending::out_of_budget) checkpoints->remove();
  if (!came_through) {
    const auto text = fmt::format("{}: {}", run.scheme.id, describe(scene.problem, path));
    throw RunFailure(text, run.scheme.id, path);
  }
  std::erase_if(run.times, [&](double t) { return path.ending == Ending::event && t > path.reached; });

  SolvedTable table = arguments.events ? table_of_events(scene, run.scheme, path)
                      : by_columns     ? table_of(scene, run, path, kept.times(), kept.columns())
                                   : table_of(scene, run, path, path.times, columns_of(scene.outputs, path));
  if (run.keeps_states) table.field = states_at(path, table.times);
  if (checkpoints) table.checkpoint = *arguments.checkpoint;
  if (arguments.all) {  // with other steps the solutions are others, or in another order: nothing is compared
    add_others(table, scene, run, path.others);
  } else {
    table.warning = run.grid ? warning_line(scene, run, path, arguments.check)
                             : warning_line(scene, run, table, path, elapsed.count(), arguments.check);
  }
  table.ended = ended_by(scene, path);
  table.cost = cost_text(scene, run, path.cost, elapsed.count(), checkpoints ? &*checkpoints : nullptr);
  return table;
}

}  // namespace fde
