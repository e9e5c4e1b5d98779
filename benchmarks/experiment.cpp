#include "experiment.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "measures.hpp"

namespace fde {

Rows TruthTable::at(const Grid& grid, const std::vector<int>& steps) {
  Rows components(scene_.problem.size(), static_cast<Eigen::Index>(steps.size()));
  for (std::size_t c = 0; c < steps.size(); ++c) {
    const double t = grid.time(steps[c]);
    auto found = known_.find(t);
    if (found == known_.end()) found = known_.emplace(t, truth(t).value).first;
    components.col(static_cast<Eigen::Index>(c)) = found->second;
  }
  return shown(scene_, components);
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

double TruthTable::bound(const Grid& grid) { return shown(scene_, truth(grid.end).bound).maxCoeff(); }

Scene make_scene(const SceneMaker& maker, const std::map<std::string, double>& values) {
  return maker.make(Parameters(maker.id, maker.parameters, values));
}

std::string describe(const Trajectory& path) {
  if (path.outcome == Outcome::finished) return "finished";
  return fmt::format("{} at step {}, t = {:.6g}",
                     path.outcome == Outcome::not_finite ? "not finite" : "Newton's method did not converge",
                     path.reached + 1, path.grid.time(path.reached + 1));
}

namespace {

// At least `repeats` solves, and so many that short ones add up to something a clock can tell.
constexpr double least_seconds = 0.02;

struct TimedSolve {
  Trajectory path;
  std::vector<double> seconds;
};

TimedSolve solve_repeatedly(const Scheme& scheme, const Problem& problem, const Grid& grid,
                            const Options& options, int repeats) {
  TimedSolve result;
  double total = 0.0;
  while (std::ssize(result.seconds) < repeats || total < least_seconds) {
    const auto start = std::chrono::steady_clock::now();
    result.path = scheme.solve(problem, grid, options);
    result.seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    total += result.seconds.back();
    if (result.path.outcome != Outcome::finished) break;
  }
  return result;
}

// A row for every measure that applies; throws std::range_error where one is not finite.
std::vector<Record> measure(const Observation& run, const Record& row) {
  std::vector<Record> rows;
  for (const auto& measure : measures()) {
    if (!measure.applies(run)) continue;
    rows.push_back(row);
    rows.back().quantity = measure.id;
    rows.back().value = measure.value(run);
    rows.back().unit = measure.unit;
    if (!std::isfinite(rows.back().value))
      throw std::range_error(fmt::format("{} is not finite", measure.id));
  }
  return rows;
}

}  // namespace

std::vector<Record> run_experiment(const std::string& label, const Scene& scene, TruthTable& truth,
                                   const Scheme& scheme, int steps, int repeats) {
  const Grid grid{.end = scene.problem.end, .steps = steps};
  const Options options{};
  const Record row{.scene = label,
                   .scheme = std::string(scheme.id),
                   .history = std::string(name(resolve(options.history, grid))),
                   .steps = steps,
                   .h = grid.step()};
  const auto outcome = [&](double reached, const std::string& status) {
    Record last = row;
    last.quantity = "outcome";
    last.value = reached;
    last.unit = "t";
    last.status = status;
    return last;
  };
  if (const auto reason = refusal(scheme, scene.problem, grid)) return {outcome(0.0, "refused: " + *reason)};
  const auto [path, seconds] = solve_repeatedly(scheme, scene.problem, grid, options, repeats);
  if (path.outcome != Outcome::finished) return {outcome(grid.time(path.reached), describe(path))};
  try {
    const Rows values = shown(scene, path.y), exact = truth.at(grid, path.steps);
    auto rows = measure({scene, scheme, options, path, values, exact, truth.bound(grid), seconds}, row);
    rows.push_back(outcome(grid.end, "finished"));
    return rows;
  } catch (const std::runtime_error& failure) {  // of a measure, or of the reference
    return {outcome(grid.end, failure.what())};
  }
}

}  // namespace fde
