// SPDX-License-Identifier: MIT
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

#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"

namespace fde::bench {

// The final values of a run, to the bit: an entry of tests/bits.txt, as printed by fde_bits.
struct FinalValues {
  std::string run;  // "relaxation l1 64"
  std::vector<double> values;
  double size = 0.0;  // the largest |value| of any component during the run; not in the table
};

// The final values of every scheme on scenes of each kind: linear, nonlinear, a chain, with a constraint,
// two-sided; with the direct history (few steps) and with exponentials. A scheme that refuses a scene has no
// entry there.
inline std::vector<FinalValues> final_values() {
  std::vector<FinalValues> found;
  for (const std::string_view id :
       {"relaxation", "relaxation_pair", "diethelm", "bagley_torvik", "pendulum", "brusselator", "knife_edge",
        "fractional_constraint_2d", "two_sided_constraint"}) {
    const SceneFactory& factory = *find_scene(id);
    const Scene scene = make_scene(factory);
    for (const auto& scheme : schemes()) {
      for (const int steps : {64, 1500}) {
        const Grid grid{.end = scene.problem.end, .steps = steps};
        if (unsupported_reason(scheme, scene.problem, grid)) continue;
        double size = 0.0;
        const auto grow = [&size](double, In y) { size = std::max(size, y.cwiseAbs().maxCoeff()); };
        const auto path = scheme.solve(scene.problem, grid, {.output_times = {grid.end}, .observer = grow});
        if (path.status != SolveStatus::finished) continue;
        const Vec last = path.y.col(0);
        found.push_back({fmt::format("{} {} {}", id, scheme.id, steps), {last.begin(), last.end()}, size});
      }
    }
  }
  return found;
}

// The largest difference from the table, in units in the last place of the largest value of the run: rounding
// errors of this size remain where the values have become small.
inline double ulps_between(const FinalValues& run, const std::vector<double>& table) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (run.values.size() != table.size()) return infinity;
  double difference = 0.0;
  for (std::size_t i = 0; i < table.size(); ++i)
    difference = std::max(difference, std::abs(run.values[i] - table[i]));
  return difference / (std::nextafter(run.size, infinity) - run.size);
}

// Reads a file written by fde_bits.
inline std::vector<FinalValues> read_final_values(const std::string& file) {
  std::vector<FinalValues> found;
  std::ifstream table(file);
  for (std::string line; std::getline(table, line);) {
    std::istringstream cells(line);
    std::string scene, scheme, steps, text;
    cells >> scene >> scheme >> steps;
    FinalValues ending{fmt::format("{} {} {}", scene, scheme, steps), {}};
    while (cells >> text) ending.values.push_back(std::strtod(text.c_str(), nullptr));
    found.push_back(std::move(ending));
  }
  return found;
}

}  // namespace fde::bench
