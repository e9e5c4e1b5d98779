#include "two_sided/solution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "two_sided/all_nodes.hpp"
#include "two_sided/clustered_panels.hpp"
#include "two_sided/sinc_nodes.hpp"

namespace fde {
namespace {

constexpr int points = 14, panels = 9, coarse_points = 12, coarse_panels = 8;
constexpr double sinc_step = 0.08;
constexpr double roundings = 64 * 0x1p-53;

// The clustered times of the points that the table keeps of a panel.
std::vector<BothShares> dense_times(const PanelBasis& basis, int panel) {
  std::vector<BothShares> times;
  const auto count = basis.dense_nodes.size();
  for (Eigen::Index j = 0; j < count; ++j) {
    const double from_start = (panel + basis.dense_nodes[j]) / panels;
    const double from_end = (panels - 1 - panel + basis.dense_nodes[count - 1 - j]) / panels;
    times.push_back(clustered({from_start, from_end}));
  }
  return times;
}

// The largest on a panel and its neighbours: errors change sign.
std::vector<Vec> spread(const std::vector<Vec>& differences) {
  std::vector<Vec> result = differences;
  for (std::size_t k = 0; k < differences.size(); ++k) {
    if (k > 0) result[k] = result[k].cwiseMax(differences[k - 1]);
    if (k + 1 < differences.size()) result[k] = result[k].cwiseMax(differences[k + 1]);
  }
  return result;
}

}  // namespace

PanelTable two_sided_table(const Problem& problem) {
  const PanelBasis fine(points, PanelPoints::legendre), coarse(coarse_points, PanelPoints::legendre);
  const NodalBasis of_first = clustered_panels(fine, panels),
                   of_other = clustered_panels(coarse, coarse_panels), of_second = sinc_nodes(sinc_step);
  const NodalSolution first(problem, of_first), other(problem, of_other), second(problem, of_second);
  PanelTable table;
  std::vector<Vec> differences;
  const Vec size = first.at_nodes().cwiseAbs().colwise().maxCoeff().transpose();
  for (int k = 0; k < panels; ++k) {
    const auto times = dense_times(fine, k);
    Matrix values(std::ssize(times), problem.size());
    Vec difference = Vec::Zero(problem.size());
    for (std::size_t j = 0; j < times.size(); ++j) {
      const Vec y = first.at(times[j]);
      values.row(static_cast<Eigen::Index>(j)) = y.transpose();
      difference = difference.cwiseMax((y - other.at(times[j])).cwiseAbs());
      difference = difference.cwiseMax((y - second.at(times[j])).cwiseAbs());
    }
    differences.push_back(difference);
    table.panels.push_back({problem.end * k / panels, problem.end * (k + 1) / panels, values, {}});
  }
  const auto spread_differences = spread(differences);
  for (std::size_t k = 0; k < table.panels.size(); ++k)
    table.panels[k].bound = 2.0 * spread_differences[k] + roundings * size;
  return table;
}

Reference two_sided_reference(PanelTable table, double end) {
  // At the start a reference that is stepped from there is exact. Here right rows are not.
  Vec at_start = table.panels.front().bound;
  return {[clustered_times = panel_reference(std::move(table), std::move(at_start)),
           end](double t) -> ReferenceValue {
    if (!(t >= 0.0 && t <= end))
      throw std::invalid_argument(fmt::format("t = {}: must be in [0, {}]", t, end));
    return clustered_times.at(end * unclustered({t / end, (end - t) / end}).from_start);
  }};
}

}  // namespace fde
