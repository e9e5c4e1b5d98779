#pragma once

#include <map>
#include <vector>

#include "record.hpp"
#include "scene.hpp"
#include "scheme.hpp"

namespace fde {

// The truth of one scene at grid times, each time evaluated once: refined grids share their times. The scene
// must live as long.
class TruthTable {
 public:
  explicit TruthTable(const Scene& scene) : scene_(scene) {}

  // The scene's columns at the steps of a grid, one column a step. Throws std::runtime_error where there is
  // no reference to be had.
  Rows at(const Grid& grid, const std::vector<int>& steps);

  // The bound of the truth at the end of the grid, the largest over the scene's columns.
  double bound(const Grid& grid);

 private:
  Truth truth(double t);

  const Scene& scene_;
  Exact exact_{};          // made when first asked for
  std::string failure_{};  // why there is none: the same for every time
  std::map<double, Vec> known_{};
};

// The scene made from its defaults with some values replaced.
Scene make_scene(const SceneMaker& maker, const std::map<std::string, double>& values = {});

// Why a run ended early, with step and time: "not finite at step 94, t = 18.4"; "finished" when it did not.
std::string describe(const Trajectory& path);

// Solves `repeats` times, more where that takes less than 20 ms, and takes every measure that applies; the
// rows carry the label as their scene. The last row is the outcome; a scheme that refuses or fails has this
// row only.
std::vector<Record> run_experiment(const std::string& label, const Scene& scene, TruthTable& truth,
                                   const Scheme& scheme, int steps, int repeats);

}  // namespace fde
