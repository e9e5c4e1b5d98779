// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/run_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <variant>
#include <vector>

#include "fdebench/benchmarks/requests/run_table.hpp"
#include "fdebench/schemes/diagnostics/other_steps.hpp"
#include "fdebench/schemes/diagnostics/warnings.hpp"

namespace fde::bench {
namespace {

// The column that shows a component as it is, or else the name of its row, "" where it has none: seen where
// all components differ.
std::vector<std::string> names_of_components(const Scene& scene) {
  const Vec y = Vec::LinSpaced(scene.problem.size(), 0.1, 0.7);
  const Vec columns = columns_at(scene.outputs, 0.0, y);
  auto names = scene.row_names;
  names.resize(static_cast<std::size_t>(y.size()));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto shown = std::ranges::find(columns, y[static_cast<Eigen::Index>(i)]);
    if (shown != columns.end())
      names[i] = scene.outputs.names[static_cast<std::size_t>(shown - columns.begin())];
  }
  return names;
}

// The printed functions of a state in which runs are compared: the energy, and multipliers without memory.
std::vector<std::string> names_of_functions(const Scene& scene) {
  std::vector<std::string> names;
  if (scene.energy) names.emplace_back("energy");
  if (scene.reactions.depends_on_columns_only())
    std::ranges::copy(scene.reactions.names, std::back_inserter(names));
  return names;
}

Vec functions_at(const Scene& scene, double t, In y) {
  const Vec columns = columns_at(scene.outputs, t, y);
  Vec values(std::ssize(names_of_functions(scene)));
  Eigen::Index next = 0;
  if (scene.energy) values[next++] = scene.energy.value(columns);
  if (scene.reactions.depends_on_columns_only())
    scene.reactions.multipliers(t, columns, Vec(), values.tail(values.size() - next));
  return values;
}

// A drift in the last quarter of the steps that is a large part of the terms of its constraint.
std::optional<Warning> large_drift(const Scene& scene, const Grid& grid, const Trajectory& path) {
  if (!scene.constraint) return std::nullopt;
  double drift = 0.0, terms = 0.0;
  for (const double t : late_times(grid)) {
    const Vec columns = columns_at(scene.outputs, t, stored_at(path, t));
    drift = std::max(drift, scene.constraint.drift(t, columns));
    terms = std::max(terms, scene.constraint.terms(t, columns));
  }
  if (!(drift > significant_part * terms)) return std::nullopt;
  return Warning{
      Finding::drift,
      fmt::format("constraint is {:.3g} in the last quarter, and its terms up to {:.3g}", drift, terms)};
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
// is printed, once for the columns of the solution and once for the others, energies and multipliers. Each of
// at most two runs may take four times as long.
std::vector<Warning> accuracy_warnings(const Scene& scene, const RequestedRun& run, const SolvedTable& table,
                                       const Trajectory& path, double seconds, bool check) {
  constexpr double most_times = 4.0, min_seconds = 0.05;
  if (table.times.empty()) return {};
  const auto columns = spread_columns(std::ssize(table.times));
  RequestedRun other = run;
  other.times.clear();
  for (const auto c : columns) other.times.push_back(table.times[static_cast<std::size_t>(c)]);
  other.options.events.clear();
  other.options.checkpoints = nullptr;
  other.options.budget = std::max(most_times * seconds, min_seconds);
  other.options.output_times = times_to_return(scene, other);
  Problem problem = scene.problem;
  if (path.status == SolveStatus::terminal_event && !is_two_sided(problem))
    problem.end = other.options.output_times.back();
  const auto compute = [&](const Tolerance& requested) -> std::optional<Rows> {
    const auto solved = run.scheme.solve(problem, requested, other.options);
    if (solved.status != SolveStatus::finished) return std::nullopt;
    try {
      return table_of(scene, other, solved, solved.times, columns_of(scene.outputs, solved)).values;
    } catch (const NumericalFailure&) {
      return std::nullopt;
    }
  };
  const auto accuracy = std::get<Tolerance>(run.resolution);
  std::map<double, std::optional<Rows>> computed;
  std::vector<Warning> found_so_far;
  const auto add = [&](Eigen::Index first, Eigen::Index count) {
    const auto values = [&](const Tolerance& requested) -> std::optional<Rows> {
      const auto found = computed.find(requested.rtol);
      const auto& all =
          found != computed.end() ? found->second : computed[requested.rtol] = compute(requested);
      return all ? std::optional<Rows>(all->middleRows(first, count)) : std::nullopt;
    };
    const Rows printed = table.values(Eigen::seqN(first, count), columns);
    const auto missed = missed_accuracy(accuracy, printed, values, check);
    if (!missed) return;
    found_so_far.push_back(
        {Finding::accuracy,
         fmt::format("{} at t = {:.6g} is off by about {:.2g} times the requested accuracy",
                     table.names[static_cast<std::size_t>(first + missed->row)],
                     other.times[static_cast<std::size_t>(missed->column)], missed->times)});
  };
  const auto unknowns = std::ssize(scene.outputs.names);
  add(0, unknowns);
  if (table.values.rows() > unknowns) add(unknowns, table.values.rows() - unknowns);
  return found_so_far;
}

}  // namespace

std::vector<Warning> run_warnings(const Scene& scene, const RequestedRun& run, const Trajectory& path,
                                  bool check) {
  std::vector<Warning> all;
  for (const auto& event : scene.events) {
    if (!event.terminal) continue;
    all.push_back(
        {Finding::event, fmt::format("event {} does not end this run: {} steps over a grid and locates none",
                                     event.name, run.scheme.id)});
  }
  SolvedRun solved{run.scheme, scene.problem, *run.grid, run.options, path, names_of_components(scene)};
  if (const auto more = names_of_functions(scene); !more.empty()) {
    solved.names.insert(solved.names.end(), more.begin(), more.end());
    solved.functions = [&scene](double t, In y) { return functions_at(scene, t, y); };
  }
  std::ranges::copy(warnings(solved, check), std::back_inserter(all));
  if (const auto drift = large_drift(scene, *run.grid, path)) all.push_back(*drift);
  return all;
}

std::vector<Warning> run_warnings(const Scene& scene, const RequestedRun& run, const SolvedTable& table,
                                  const Trajectory& path, double seconds, bool check) {
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  const auto accuracy = std::get<Tolerance>(run.resolution);
  std::vector<Warning> all;
  if (accuracy.rtol < rounding) {
    all.push_back(
        {Finding::accuracy, fmt::format("an accuracy of {:.3g} is requested, and a double has {:.2g}",
                                        accuracy.rtol, rounding)});
  } else {
    all = accuracy_warnings(scene, run, table, path, seconds, check);
  }
  const Rows columns = columns_of(scene.outputs, path);
  for (const auto& event : scene.events) {
    bool is_number = columns.cols() == 0;
    for (Eigen::Index c = 0; c < columns.cols() && !is_number; ++c)
      is_number = !std::isnan(event.value(path.time(c), columns.col(c)));
    if (is_number) continue;
    all.push_back(
        {Finding::event, fmt::format("event {} is not a number at any time of the run", event.name)});
  }
  return all;
}

}  // namespace fde::bench
