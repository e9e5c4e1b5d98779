// SPDX-License-Identifier: MIT
#include "fdebench/reference/two_sided/solution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "fdebench/reference/two_sided/nodal_basis.hpp"
#include "fdebench/reference/two_sided/nodal_equations.hpp"

namespace fde::reference {
namespace {

constexpr int points = 14, coarse_points = 12;
constexpr int few_points = 6, few_panels = 6;
constexpr double sinc_step = 0.08;
constexpr double roundings = 64 * 0x1p-53;

// A solution that starts like t^g, g the smallest order, starts like x^4 (g >= 1/8), or like a lower power: a
// stronger clustering would leave too few panels for the middle.
ClusteringMap time_of(const Problem& problem) {
  constexpr double smooth = 4.0, usual = 8.0, most = 32.0;
  return ClusteringMap(std::clamp(smooth / smallest_order(problem), usual, most));
}

// Number of panels, `usual` for the power 8: for a larger power t(x) is steeper between the ends and the
// middle.
int count_of(int usual, const ClusteringMap& time) {
  return static_cast<int>(std::ceil(usual * std::sqrt(time.power() / 8.0)));
}

// The times of the points that the table stores for a panel.
std::vector<RelativeTime> dense_times(const PanelBasis& basis, int panel, int panels,
                                      const ClusteringMap& time) {
  std::vector<RelativeTime> times;
  const auto count = basis.dense_nodes.size();
  for (Eigen::Index j = 0; j < count; ++j) {
    const double from_start = (panel + basis.dense_nodes[j]) / panels;
    const double from_end = (panels - 1 - panel + basis.dense_nodes[count - 1 - j]) / panels;
    times.push_back(time.at({from_start, from_end}));
  }
  return times;
}

// The largest difference on a panel and its neighbours, since errors change sign.
std::vector<Vec> max_over_neighbours(const std::vector<Vec>& differences) {
  std::vector<Vec> result = differences;
  for (std::size_t k = 0; k < differences.size(); ++k) {
    if (k > 0) result[k] = result[k].cwiseMax(differences[k - 1]);
    if (k + 1 < differences.size()) result[k] = result[k].cwiseMax(differences[k + 1]);
  }
  return result;
}

// Newton's method from the Taylor part or, if that fails for a nonlinear problem, from smallest_solution() on
// a coarse basis.
NodalSolution solution_on(const Problem& problem, const NodalBasis& basis, const ClusteringMap& time) {
  try {
    return {problem, basis};
  } catch (const std::runtime_error&) {
    if (is_linear(problem)) throw;
    const PanelBasis few(few_points, PanelPoints::legendre);
    const NodalBasis of_few = clustered_panels(few, count_of(few_panels, time), time);
    const NodalSolution rough = smallest_solution(problem, of_few);
    return {problem, basis, [&](RelativeTime t) { return rough.at(t); }};
  }
}

// Neither method chooses its nodes by the solution: both would pass over a load that changes quickly.
void require_slow_loads(const Problem& problem) {
  constexpr double resolved = 0.05;  // of the end
  for (const auto& limit : problem.step_limits) {
    if (limit.to - limit.from < resolved * problem.end) {
      throw std::runtime_error(fmt::format(
          "two methods: a load changes within t = {:.6g} ... {:.6g}, a time that they do not resolve",
          limit.from, limit.to));
    }
  }
}

}  // namespace

PanelTable two_sided_table(const Problem& problem) {
  require_slow_loads(problem);
  const PanelBasis fine(points, PanelPoints::legendre), coarse(coarse_points, PanelPoints::legendre);
  const ClusteringMap time = time_of(problem);
  const int panels = count_of(9, time);
  const NodalBasis of_first = clustered_panels(fine, panels, time),
                   of_other = clustered_panels(coarse, count_of(8, time), time),
                   of_second = sinc_nodes(sinc_step);
  const NodalSolution first = solution_on(problem, of_first, time);
  const auto found = [&](RelativeTime t) { return first.at(t); };
  const NodalSolution other(problem, of_other, found), second(problem, of_second, found);
  PanelTable table;
  std::vector<Vec> differences;
  const Vec size = first.at_nodes().cwiseAbs().colwise().maxCoeff().transpose();
  for (int k = 0; k < panels; ++k) {
    const auto times = dense_times(fine, k, panels, time);
    Matrix values(std::ssize(times), problem.size());
    Vec difference = Vec::Zero(problem.size());
    for (std::size_t j = 0; j < times.size(); ++j) {
      const Vec y = first.at(times[j]);
      values.row(static_cast<Eigen::Index>(j)) = y.transpose();
      difference = difference.cwiseMax((y - other.at(times[j])).cwiseAbs());
      difference = difference.cwiseMax((y - second.at(times[j])).cwiseAbs());
    }
    differences.push_back(difference);
    // The last edge has to be the end exactly: (end * panels) / panels may differ.
    const auto edge = [&](double number) { return problem.end * (number / panels); };
    table.panels.push_back({edge(k), edge(k + 1.0), values, {}});
  }
  const auto spread_differences = max_over_neighbours(differences);
  for (std::size_t k = 0; k < table.panels.size(); ++k)
    table.panels[k].bound = 2.0 * spread_differences[k] + roundings * size;
  return table;
}

Reference two_sided_reference(PanelTable table, const Problem& problem) {
  // The bound at t = 0 is not 0: components with right derivatives are not given there.
  Vec at_start = table.panels.front().bound;
  return {[clustered_times = reference_from_panels(std::move(table), std::move(at_start)), end = problem.end,
           time = time_of(problem)](double t) -> ReferenceValue {
    if (!(t >= 0.0 && t <= end))
      throw std::invalid_argument(fmt::format("t = {}: must be in [0, {}]", t, end));
    return clustered_times.at(end * time.inverse({t / end, (end - t) / end}).from_start);
  }};
}

}  // namespace fde::reference
