#include "experiment.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "accuracy.hpp"
#include "drift.hpp"
#include "energy_balance.hpp"
#include "measures.hpp"
#include "rounding.hpp"

namespace fde {

Rows TruthTable::at(const Grid& grid, const std::vector<int>& steps) {
  Rows columns(static_cast<Eigen::Index>(scene_.outputs.names.size()),
               static_cast<Eigen::Index>(steps.size()));
  for (std::size_t c = 0; c < steps.size(); ++c) {
    const double t = grid.time(steps[c]);
    auto found = known_.find(t);
    if (found == known_.end()) found = known_.emplace(t, truth(t).value).first;
    columns.col(static_cast<Eigen::Index>(c)) = found->second;
  }
  return columns;
}

Truth TruthTable::truth(double t) {
  if (!failure_.empty()) throw std::runtime_error(failure_);
  try {
    if (!exact_.at) exact_ = truth_of(scene_);
    return exact_.at(t);
  } catch (const std::runtime_error& error) {
    failure_ = fmt::format("no reference: {}", error.what());
    throw std::runtime_error(failure_);
  }
}

Vec TruthTable::bound(const Grid& grid) { return truth(grid.end).bound; }

namespace {

std::string reason(const Problem& problem, Outcome outcome) {
  switch (outcome) {
    case Outcome::finished:
      return "finished";
    case Outcome::not_finite:
      return "not finite";
    case Outcome::not_converged:
      return "Newton's method did not converge";
    case Outcome::singular:
      return fmt::format("ran into the singularity {}", problem.domain.edge);
    case Outcome::out_of_budget:
      return "out of its budget of time";
  }
  throw std::logic_error("an outcome without a description");
}

}  // namespace

std::string describe(const Problem& problem, const Trajectory& path) {
  const auto why = reason(problem, path.outcome);
  if (path.outcome == Outcome::finished) return why;
  const int step = path.reached + 1;
  return fmt::format("{} at step {}, t = {:.6g}", why, step, path.grid.time(step));
}

namespace {

// `repeats` solves, more where short ones do not add up to something a clock can tell, fewer where they are
// long.
constexpr double least_seconds = 0.02, enough_seconds = 10.0;

std::vector<double> solve_repeatedly(const Scheme& scheme, const Problem& problem, const Grid& grid,
                                     int repeats) {
  const Options options{.keep = {grid.steps}};
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

// The truth beside a path, or why there is none.
struct Known {
  Rows truth{};
  Vec bound{};
  std::string missing{};
};
Known what_is_known(TruthTable& truth, const Trajectory& path) {
  try {
    return {truth.at(path.grid, path.steps), truth.bound(path.grid)};
  } catch (const std::runtime_error& failure) {
    return {.missing = failure.what()};
  }
}

// The columns at the same steps, computed in other units; none where that run does not finish.
Rows rounded_otherwise(const Scene& scene, const Scheme& scheme, const Grid& grid, Options options) {
  constexpr double unit = 0.7;
  options.watch = {};
  auto path = scheme.solve(in_units_of(unit, scene.problem), grid, options);
  if (path.outcome != Outcome::finished) return {};
  path.y *= unit;
  return columns_of(scene.outputs, path);
}

}  // namespace

Examination examine(const std::string& label, const Scene& scene, TruthTable& truth, const Scheme& scheme,
                    int steps, double budget) {
  const Grid grid{.end = scene.problem.end, .steps = steps};
  Options options{.budget = budget, .keep = watched_steps(steps)};
  const Record row = row_of(label, scheme, grid, options);
  const auto outcome = [&](double reached, const std::string& status) {
    Record last = with_value(row, "outcome", reached, "t");
    last.status = status;
    return last;
  };
  if (const auto reason = refusal(scheme, scene.problem, grid))
    return {{outcome(0.0, "refused: " + *reason)}};
  EnergyBalance balance(scene.energy);
  DriftWatch drift(scene, grid);
  if (scene.energy.power || scene.constraint) {
    options.watch = [&](int n, In y) {
      const Vec columns = columns_at(scene.outputs, grid.time(n), y);
      if (scene.energy.power) balance.see(grid.time(n), columns);
      if (scene.constraint) drift.see(n, columns);
    };
  }
  const auto path = scheme.solve(scene.problem, grid, options);
  if (path.outcome != Outcome::finished)
    return {{outcome(grid.time(path.reached), describe(scene.problem, path))}};
  try {
    const Known known = what_is_known(truth, path);
    const auto step = [&](Eigen::Index column) { return path.steps[static_cast<std::size_t>(column)]; };
    const auto time = [&](Eigen::Index column) { return grid.time(step(column)); };
    const auto at = [&](std::string_view what, Eigen::Index column) {
      return fmt::format("{} at step {}, t = {:.6g}", what, step(column), time(column));
    };
    if (const auto beyond = first_beyond_double(known.truth))
      return {{outcome(time(*beyond), at("the solution is beyond double", *beyond))}};
    const Rows values = columns_of(scene.outputs, path);
    Observation run{scene,
                    scheme,
                    path,
                    values,
                    known.truth,
                    known.bound,
                    rounded_otherwise(scene, scheme, grid, options),
                    balance.residual()};
    if (scene.constraint) {
      run.internal_drift = drift.internal();
      run.independent_drift = drift.independent();
    }
    auto rows = measure(run, row);
    if (!known.missing.empty()) {
      rows.push_back(outcome(grid.end, known.missing));
    } else if (const auto lost = accuracy_lost(values, known.truth)) {
      rows.push_back(outcome(time(*lost), at(lost_status, *lost)));
    } else {
      rows.push_back(outcome(grid.end, std::string(finished_status)));
    }
    return {std::move(rows), known.missing.empty()};
  } catch (const std::runtime_error& failure) {  // of a measure
    return {{outcome(grid.end, failure.what())}};
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
