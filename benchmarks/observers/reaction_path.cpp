// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/observers/reaction_path.hpp"

#include <algorithm>
#include <iterator>

#include "fdebench/benchmarks/observers/differentiation_rule.hpp"

namespace fde::bench {

std::vector<double> with_neighbour_times(const Reactions& reactions, const std::optional<Grid>& grid,
                                         std::vector<double> times, double end) {
  if (reactions.differentiated_columns.empty()) return times;
  std::vector<double> beside;
  for (const double t : times) {
    if (t == 0.0) continue;
    if (grid) {
      for (const int step :
           differentiation_rule(*grid, grid->nearest_index(t), reactions.start_exponents).steps)
        beside.push_back(grid->time(step));
    } else {
      std::ranges::copy(derivative_times(t, end), std::back_inserter(beside));
    }
  }
  times.insert(times.end(), beside.begin(), beside.end());
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

ReactionPath::ReactionPath(const Scene& scene, const std::optional<Grid>& grid, const Trajectory& path)
    : scene_(scene), grid_(grid), path_(path) {}

std::vector<std::string> ReactionPath::names() const {
  return scene_.reactions ? reaction_names(scene_) : std::vector<std::string>{};
}

Vec ReactionPath::at(Eigen::Index c, In columns) const {
  // Without reactions the columns may be stored separately, and the path then has fewer times.
  if (!scene_.reactions) return {};
  const double t = path_.time(c);
  return reaction_values(scene_, t, columns, rates(t));
}

Vec ReactionPath::columns_to_differentiate_at(double t) const {
  const auto column = std::ranges::lower_bound(path_.times, t) - path_.times.begin();
  return columns_at(scene_.outputs, t, path_.y.col(column))(scene_.reactions.differentiated_columns);
}

std::optional<Vec> ReactionPath::rates(double t) const {
  if (scene_.reactions.differentiated_columns.empty() || t == 0.0) return std::nullopt;
  if (!grid_) {
    return derivative_at(t, scene_.problem.end,
                         [this](double beside) { return columns_to_differentiate_at(beside); });
  }
  const auto [steps, weights] =
      differentiation_rule(*grid_, grid_->nearest_index(t), scene_.reactions.start_exponents);
  Vec rates = Vec::Zero(std::ssize(scene_.reactions.differentiated_columns));
  for (std::size_t k = 0; k < steps.size(); ++k)
    rates += weights[static_cast<Eigen::Index>(k)] * columns_to_differentiate_at(grid_->time(steps[k]));
  return rates;
}

}  // namespace fde::bench
