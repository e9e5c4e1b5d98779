#include "sweep/experiment.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "march/singularity.hpp"
#include "measures/accuracy.hpp"
#include "measures/measures.hpp"
#include "measures/rounding.hpp"
#include "observers/drift.hpp"
#include "observers/energy_balance.hpp"
#include "observers/watched_steps.hpp"
#include "sweep/ending.hpp"

namespace fde {

namespace {

// `repeats` solves, more where short ones do not add up to something a clock can tell, fewer where they are
// long.
constexpr double least_seconds = 0.02, enough_seconds = 10.0;

std::vector<double> solve_repeatedly(const Scheme& scheme, const Problem& problem, const Grid& grid,
                                     int repeats) {
  const Options options{.at = {grid.end}};
  std::vector<double> seconds;
  double total = 0.0;
  while (total < least_seconds || (std::ssize(seconds) < repeats && total < enough_seconds)) {
    const auto start = std::chrono::steady_clock::now();
    const auto path = scheme.solve(problem, grid, options);
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    total += seconds.back();
  }
  return seconds;
}

Record row_of(const std::string& label, const Scheme& scheme, const Grid& grid, const Options& options) {
  return {.scene = label,
          .scheme = std::string(scheme.id),
          .history = std::string(name(options.history)),
          .steps = grid.steps,
          .h = grid.step(),
          .tolerance = options.tolerance};
}

Record with_value(Record row, std::string_view quantity, double value, std::string_view unit) {
  if (!std::isfinite(value)) throw std::range_error(fmt::format("{} is not finite", quantity));
  row.quantity = quantity;
  row.value = value;
  row.unit = unit;
  return row;
}

// A row for every measure that applies; throws std::range_error where one is not finite.
std::vector<Record> measure(const Observation& run, const Record& row) {
  std::vector<Record> rows;
  for (const auto& measure : measures()) {
    if (measure.applies(run)) rows.push_back(with_value(row, measure.id, measure.value(run), measure.unit));
  }
  return rows;
}

// The reference beside a path, or why there is none, as a status.
struct Known {
  Rows reference{};
  Vec bound{};
  std::string missing{};
};
Known what_is_known(WatchedReference& reference, const Trajectory& path) {
  try {
    return {reference.at(path.times), reference.bound(path.reached)};
  } catch (const Singularity& failure) {
    return {.missing = fmt::format("passed a singularity of the solution ({})", failure.what())};
  } catch (const std::runtime_error& failure) {
    return {.missing = fmt::format("{}{}", words(Ending::no_reference), failure.what())};
  }
}

// The columns at the same steps, computed in other units; none where that run does not finish.
Rows rounded_otherwise(const Scene& scene, const Scheme& scheme, const Grid& grid, Options options) {
  constexpr double unit = 0.7;
  options.observer = {};
  auto path = scheme.solve(in_units_of(unit, scene.problem), grid, options);
  if (path.ending != Ending::finished) return {};
  path.y *= unit;
  return columns_of(scene.outputs, path);
}

// How a run ended, and where.
struct End {
  std::string status;
  double t;
};

// Of a run that stopped. One that left the domain of its problem was right, unless the solution stays inside.
End end_of_stopped(const Scene& scene, const Trajectory& path, WatchedReference& reference) {
  std::string status = describe(scene.problem, path);
  if (path.ending == Ending::singular && what_is_known(reference, path).missing.empty())
    status = "unlike the solution, " + status;
  return {std::move(status), path.reached};
}

// Of a run that came to its end.
End end_of_finished(const Resolution& resolution, const Trajectory& path, const Rows& values,
                    const Known& known) {
  const auto from = [&](Ending ending, Eigen::Index column) -> End {
    const double t = path.time(column);
    return {at_time(words(ending), resolution, t), t};
  };
  if (!known.missing.empty()) return {known.missing, path.reached};
  if (const auto lost = accuracy_lost(values, known.reference)) {
    const bool until_beyond = lost == first_overflow(known.reference);
    return from(until_beyond ? Ending::overflow : Ending::accuracy_lost, *lost);
  }
  return {std::string(words(Ending::finished)), path.reached};
}

Record outcome(const Record& row, const End& end) {
  Record last = with_value(row, "outcome", end.t, "t");
  last.status = end.status;
  return last;
}

}  // namespace

std::vector<Record> examine(const std::string& label, const Scene& scene, WatchedReference& reference,
                            const Scheme& scheme, int steps, double budget) {
  const Grid grid{.end = scene.problem.end, .steps = steps};
  Options options{.budget = budget, .at = watched_times(grid)};
  const Record row = row_of(label, scheme, grid, options);
  if (const auto reason = refusal(scheme, scene.problem, grid))
    return {outcome(row, {fmt::format("{}{}", words(Ending::refused), *reason), 0.0})};
  EnergyBalance balance(scene.energy);
  DriftWatch drift(scene, grid);
  if (scene.energy.power || scene.constraint) {
    options.observer = [&](double t, In y) {
      const Vec columns = columns_at(scene.outputs, t, y);
      if (scene.energy.power) balance.see(t, columns);
      if (scene.constraint) drift.see(t, columns);
    };
  }
  const auto path = scheme.solve(scene.problem, grid, options);
  if (path.ending != Ending::finished) return {outcome(row, end_of_stopped(scene, path, reference))};

  const Known known = what_is_known(reference, path);
  const Rows values = columns_of(scene.outputs, path);
  const End end = end_of_finished(grid, path, values, known);
  if (!known.reference.allFinite()) return {outcome(row, end)};  // no measure is finite
  try {
    Observation run{scene,
                    scheme,
                    path,
                    values,
                    known.reference,
                    known.bound,
                    rounded_otherwise(scene, scheme, grid, options),
                    grid.grading,
                    balance.residual()};
    if (scene.constraint) {
      run.internal_drift = drift.internal();
      run.independent_drift = drift.independent();
    }
    auto rows = measure(run, row);
    rows.push_back(outcome(row, end));
    return rows;
  } catch (const std::runtime_error& failure) {  // of a measure
    return {outcome(row, {failure.what(), grid.end})};
  }
}

std::vector<Record> time_solves(const std::string& label, const Scene& scene, const Scheme& scheme, int steps,
                                int repeats) {
  const Grid grid{.end = scene.problem.end, .steps = steps};
  const auto seconds = solve_repeatedly(scheme, scene.problem, grid, repeats);
  const Record row = row_of(label, scheme, grid, {});
  std::vector<Record> rows;
  for (const auto& measure : time_measures()) {
    rows.push_back(with_value(row, measure.id, measure.value(seconds), "s"));
  }
  rows.back().status = "timed";
  return rows;
}

}  // namespace fde
