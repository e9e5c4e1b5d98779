#include "observers/reaction_path.hpp"

#include <algorithm>

#include "observers/local_rate.hpp"

namespace fde {

std::vector<double> with_times_beside(const Reactions& reactions, const std::optional<Grid>& grid,
                                      std::vector<double> times) {
  if (reactions.rated.empty() || !grid) return times;
  std::vector<double> beside;
  for (const double t : times) {
    if (t == 0.0) continue;
    for (const int step : local_rate(*grid, grid->number(t), reactions.powers).steps)
      beside.push_back(grid->time(step));
  }
  times.insert(times.end(), beside.begin(), beside.end());
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

ReactionPath::ReactionPath(const Scene& scene, const std::optional<Grid>& grid, const Trajectory& path)
    : scene_(scene),
      grid_(grid),
      path_(path),
      told_(scene.reactions && (scene.reactions.of_columns() || grid)) {}

std::vector<std::string> ReactionPath::names() const {
  return told_ ? reaction_names(scene_) : std::vector<std::string>{};
}

Vec ReactionPath::at(Eigen::Index c, In columns) const {
  const double t = path_.time(c);
  return told_ ? reaction_values(scene_, t, columns, rates(t)) : Vec();
}

std::optional<Vec> ReactionPath::rates(double t) const {
  const auto& rated = scene_.reactions.rated;
  if (rated.empty() || t == 0.0) return std::nullopt;
  const auto [steps, weights] = local_rate(*grid_, grid_->number(t), scene_.reactions.powers);
  Vec rates = Vec::Zero(std::ssize(rated));
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double beside = grid_->time(steps[k]);
    const auto found = std::ranges::lower_bound(path_.times, beside);
    const auto column = static_cast<Eigen::Index>(found - path_.times.begin());
    const Vec columns = columns_at(scene_.outputs, beside, path_.y.col(column));
    for (std::size_t i = 0; i < rated.size(); ++i)
      rates[static_cast<Eigen::Index>(i)] += weights[static_cast<Eigen::Index>(k)] * columns[rated[i]];
  }
  return rates;
}

}  // namespace fde
