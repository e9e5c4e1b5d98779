#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scenes/registry.hpp"
#include "sweep/experiment.hpp"

namespace fde {

// The end of a run, to the bit: what tests/bits.txt holds of every scheme, as fde_bits printed it.
struct EndOfRun {
  std::string run;  // "relaxation l1 64"
  std::vector<double> values;
};

// Every scheme on scenes of each kind: linear, nonlinear, a chain, with a constraint, posed at both ends; the
// past as direct sums (few steps) and as exponentials. A scheme that refuses a scene has no ending there.
inline std::vector<EndOfRun> endings() {
  std::vector<EndOfRun> found;
  for (const std::string_view id :
       {"relaxation", "relaxation_pair", "diethelm", "bagley_torvik", "pendulum", "brusselator", "knife_edge",
        "fractional_constraint_2d", "two_sided_constraint"}) {
    const SceneMaker& maker = *find_scene(id);
    const Scene scene = make_scene(maker);
    for (const auto& scheme : schemes()) {
      for (const int steps : {64, 1500}) {
        const Grid grid{.end = scene.problem.end, .steps = steps};
        if (refusal(scheme, scene.problem, grid)) continue;
        const auto path = scheme.solve(scene.problem, grid, {.at = {grid.end}});
        if (path.ending != Ending::finished) continue;
        const Vec last = path.y.col(0);
        found.push_back({fmt::format("{} {} {}", id, scheme.id, steps), {last.begin(), last.end()}});
      }
    }
  }
  return found;
}

// The largest difference of two endings, in units of the last place of the largest value.
inline double ulps_between(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double size = 0.0, difference = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    size = std::max({size, std::abs(a[i]), std::abs(b[i])});
    difference = std::max(difference, std::abs(a[i] - b[i]));
  }
  return difference / (std::nextafter(size, std::numeric_limits<double>::infinity()) - size);
}

// A file of fde_bits.
inline std::vector<EndOfRun> read_endings(const std::string& file) {
  std::vector<EndOfRun> found;
  std::ifstream table(file);
  for (std::string line; std::getline(table, line);) {
    std::istringstream cells(line);
    std::string scene, scheme, steps, text;
    cells >> scene >> scheme >> steps;
    EndOfRun ending{fmt::format("{} {} {}", scene, scheme, steps), {}};
    while (cells >> text) ending.values.push_back(std::strtod(text.c_str(), nullptr));
    found.push_back(std::move(ending));
  }
  return found;
}

}  // namespace fde
