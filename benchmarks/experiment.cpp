#include "experiment.hpp"

#include <chrono>
#include <cmath>

#include "fmt/format.h"
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
  if (!exact_.at) exact_ = truth_of(scene_);
  return exact_.at(t);
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

std::vector<Record> run_experiment(const std::string& label, const Scene& scene, TruthTable& truth,
                                   const Scheme& scheme, int steps, int repeats) {
  const Grid grid{.end = scene.problem.end, .steps = steps};
  const Options options{};
  const Record row{.scene = label,
                   .scheme = std::string(scheme.id),
                   .history = std::string(name(resolve(options.history, steps))),
                   .steps = steps,
                   .h = grid.step(),
                   .quantity = "outcome",
                   .status = "finished"};
  std::vector<Record> rows;
  const auto outcome = [&](double reached, const std::string& status) {
    rows.push_back(row);
    rows.back().value = reached;
    rows.back().unit = "t";
    rows.back().status = status;
    return rows;
  };
  if (const auto reason = refusal(scheme, scene.problem, grid)) return outcome(0.0, "refused: " + *reason);

  Trajectory path;
  std::vector<double> seconds;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
    path = scheme.solve(scene.problem, grid, options);
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    if (path.outcome != Outcome::finished) return outcome(grid.time(path.reached), describe(path));
  }
  const Rows values = shown(scene, path.y), exact = truth.at(grid, path.steps);
  const Observation run{scene, scheme, options, path, values, exact, truth.bound(grid), seconds};
  for (const auto& measure : measures()) {
    if (!measure.applies(run)) continue;
    rows.push_back(row);
    rows.back().quantity = measure.id;
    rows.back().value = measure.value(run);
    rows.back().unit = measure.unit;
  }
  return outcome(grid.end, "finished");
}

}  // namespace fde
