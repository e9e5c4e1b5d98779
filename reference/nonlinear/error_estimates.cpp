// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/error_estimates.hpp"

#include <algorithm>
#include <limits>

#include "fdebench/reference/nonlinear/march/jumps.hpp"

namespace fde::reference {

namespace {

constexpr double window = 10.0;  // ratio of times: the larger errors of earlier panels have decayed

Vec difference_on(const Panel& panel, const PiecewiseSolution& solution, const PiecewiseSolution& other) {
  constexpr int samples = 40;
  Vec largest = Vec::Zero(panel.values.cols());
  for (int k = 1; k <= samples; ++k) {
    const double t = k == samples ? panel.to : panel.from + panel.length() * k / samples;
    largest = largest.cwiseMax((solution.at(t) - other.at(t)).cwiseAbs());
  }
  return largest;
}

// The largest differences from the second method on each panel, at the ends of the steps of that method.
std::vector<Vec> differences_to(const DiffusiveSolution& second, const PiecewiseSolution& solution) {
  constexpr double started =
      1e-12;  // relative to the end: the errors of the first steps of the second method have decayed
  const auto& panels = solution.panels();
  std::vector<Vec> largest(panels.size(), Vec::Zero(panels.front().values.cols()));
  for (std::size_t k = 0; k < second.times.size(); ++k) {
    const double t = second.times[k];
    if (t >= started * panels.back().to) {
      Vec& on_panel = largest[solution.panel_of(t)];
      on_panel = on_panel.cwiseMax((second.values[k] - solution.at(t)).cwiseAbs());
    }
  }
  return largest;
}

// Whether the panel is one of the first after a jump, compared with the later time `now`.
bool has_decayed(const Problem& problem, const Panel& panel, double now) {
  const double jump = last_jump(problem, panel.from);
  return jump > 0.0 && panel.to - jump < (now - jump) / window;
}

// Mean rate of change of each component on a panel.
Vec slope_on(const Panel& panel) {
  return (panel.values.colwise().maxCoeff() - panel.values.colwise().minCoeff()).transpose() / panel.length();
}

}  // namespace

std::vector<Vec> error_estimates(const Problem& problem, const PiecewiseSolution& solution,
                                 const PiecewiseSolution& other, const DiffusiveSolution& second) {
  constexpr double safety = 2.0;
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  const auto& panels = solution.panels();
  const auto to_second = differences_to(second, solution);
  std::vector<Vec> to_other, slopes, estimates;
  for (const Panel& panel : panels) {
    to_other.push_back(difference_on(panel, solution, other));
    slopes.push_back(slope_on(panel));
  }
  for (std::size_t last = 0; last < panels.size(); ++last) {
    const Vec slope = slopes[last].cwiseMax(slopes[last > 0 ? last - 1 : last]);
    Vec difference = to_other[last].cwiseMax(to_second[last]);
    for (std::size_t k = solution.panel_of(panels[last].from / window); k < last; ++k) {
      if (has_decayed(problem, panels[k], panels[last].from)) continue;
      const Vec share = (slope.array() / (slopes[k].array() + std::numeric_limits<double>::min())).min(1.0);
      difference = difference.cwiseMax(to_other[k]).cwiseMax(to_second[k].cwiseProduct(share));
    }
    estimates.emplace_back(safety * difference + rounding * panels[last].size);
  }
  return estimates;
}

}  // namespace fde::reference
