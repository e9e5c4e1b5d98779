#pragma once

#include <limits>
#include <map>
#include <vector>

#include "record.hpp"
#include "scheme.hpp"
#include "variant.hpp"

namespace fde {

// The truth of one scene at grid times, each time evaluated once: refined grids share their times. The scene
// must live as long.
class TruthTable {
 public:
  explicit TruthTable(const Scene& scene) : scene_(scene) {}

  // The scene's columns at the steps of a grid, one column a step. Throws std::runtime_error where there is
  // no reference to be had.
  Rows at(const Grid& grid, const std::vector<int>& steps);

  // The bound of the truth at the end of the grid, one value a column of the scene.
  Vec bound(const Grid& grid);

 private:
  Truth truth(double t);

  const Scene& scene_;
  Exact exact_{};          // made when first asked for
  std::string failure_{};  // why there is none: the same for every time
  std::map<double, Vec> known_{};
};

// Why a run of the problem ended early, with step and time: "not finite at step 94, t = 18.4"; "finished"
// when it did not.
std::string describe(const Problem& problem, const Trajectory& path);

// One (scene, scheme, steps) of a sweep: everything but its time.
struct Examination {
  // The last is the outcome; a scheme that refuses or fails has this one only. Without a reference the
  // outcome says why, and the measures that need none are there all the same.
  std::vector<Record> rows;
  bool finished = false;  // with a reference, and worth timing
};

// Solves once within the budget (seconds), compares with the truth at watched_steps and takes every measure
// that applies; the rows carry the label as their scene. Examinations may go on side by side, each scene with
// a TruthTable of its own.
Examination examine(const std::string& label, const Scene& scene, TruthTable& truth, const Scheme& scheme,
                    int steps, double budget = std::numeric_limits<double>::infinity());

// The time rows of a finished examination: solves `repeats` times, more where that takes less than 20 ms, no
// more once it has taken 10 s, storing the last step only. The last row has the status "timed". To be called
// while nothing else runs.
std::vector<Record> time_solves(const std::string& label, const Scene& scene, const Scheme& scheme, int steps,
                                int repeats);

}  // namespace fde
