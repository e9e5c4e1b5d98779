// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/sampled_solution.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/text/rounded_number.hpp"

namespace fde::bench {
namespace {

constexpr int first_times = 120, most_times = 400;
constexpr double allowed = 0.004;         // distance of curve and polyline, as a fraction of a column's range
constexpr Eigen::Index most_columns = 8;  // a diffusion has hundreds
constexpr double least_width = 1e-5;      // of an interval that is bisected, as a fraction of the end
constexpr int digits_of_times = 7;        // resolve half of least_width, so that rounded times increase
constexpr int digits_of_values = 4;

// The first `kept` columns at adaptively chosen times, dense where one of the first `columns` is curved.
class Samples {
 public:
  Samples(const reference::Reference& reference, Eigen::Index columns, Eigen::Index kept, double end)
      : reference_(reference), columns_(columns), kept_(kept), end_(end) {
    for (int i = 0; i <= first_times; ++i) add(end_ * i / first_times);
    Vec low = values_.begin()->second, high = low;
    for (const auto& [t, value] : values_) low = low.cwiseMin(value), high = high.cwiseMax(value);
    range_ = (high - low).head(columns_);
    for (auto left = values_.begin(); std::next(left) != values_.end();) left = refined(left);
  }

  [[nodiscard]] const std::map<double, Vec>& values() const { return values_; }
  [[nodiscard]] double bound() const { return bound_; }

 private:
  using Place = std::map<double, Vec>::iterator;

  Place add(double t) {
    const auto [value, bounds] = reference_.at(t);
    if (!value.allFinite() || !bounds.allFinite()) throw std::runtime_error("no value");
    if (bounds.size() > 0) bound_ = std::max(bound_, bounds.maxCoeff());
    return values_.insert_or_assign(t, value.head(kept_)).first;
  }

  // Bisects the interval after `left` if its polyline is too coarse. Returns the left end of the next
  // interval to check.
  Place refined(Place left) {
    const auto right = std::next(left);
    const double width = right->first - left->first;
    if (std::ssize(values_) >= most_times || width < least_width * end_) return right;
    const Vec between = 0.5 * (left->second + right->second);
    const auto middle = add(left->first + 0.5 * width);
    const Vec away = (middle->second - between).head(columns_).cwiseAbs() - allowed * range_;
    return away.maxCoeff() > 0.0 ? left : right;
  }

  const reference::Reference& reference_;
  Eigen::Index columns_, kept_;
  double end_, bound_ = 0.0;
  std::map<double, Vec> values_{};
  Vec range_{};
};

using Path = std::map<double, Vec>;

// Values along the path, one column per name.
SampledColumns columns_along(const Path& path, const std::vector<std::string>& names,
                             const std::function<Vec(double t, In columns)>& of) {
  SampledColumns sampled{.names = names};
  sampled.values.resize(names.size());
  for (const auto& [t, columns] : path) {
    const Vec at = of(t, columns);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const double value = at[static_cast<Eigen::Index>(i)];
      sampled.values[i].push_back(std::isfinite(value) ? std::optional(rounded(value, digits_of_values))
                                                       : std::nullopt);
    }
  }
  return sampled;
}

// Empty if there is no energy or it is constant.
SampledColumns energy_along(const Scene& scene, const Path& path) {
  if (!scene.energy) return {};
  auto energy = columns_along(
      path, {"energy"}, [&](double, In columns) { return Vec::Constant(1, scene.energy.value(columns)); });
  const auto& values = energy.values[0];
  const bool is_constant =
      std::ranges::all_of(values, [&](const auto& value) { return value == values.front(); });
  return is_constant ? SampledColumns{} : energy;
}

SampledColumns reactions_along(const Scene& scene, const Path& path) {
  const auto& reactions = scene.reactions;
  if (!reactions || !reactions.has_exact_multipliers()) return {};
  return columns_along(path, reactions.names, [&](double t, In columns) -> Vec {
    return exact_reactions(scene, t, columns).head(std::ssize(reactions.names));
  });
}

// The coordinates of the motion; by name only if they are among these columns of the scene.
SampledColumns motion_along(const Scene& scene, const Path& path, const std::vector<std::string>& columns) {
  const auto& names = scene.display_path.names;
  const bool are_columns = std::ranges::all_of(
      names, [&](const auto& name) { return std::ranges::find(columns, name) != columns.end(); });
  if (are_columns) return {.names = names};
  return columns_along(path, names,
                       [&](double t, In of_path) { return columns_at(scene.display_path, t, of_path); });
}

}  // namespace

SampledSolution sample_solution(const Scene& scene, const reference::Reference& reference) {
  const auto& names = scene.outputs.names;
  const auto shown = std::min<Eigen::Index>(std::ssize(names), most_columns);
  const bool needs_all = scene.energy || scene.reactions || !scene.display_path.names.empty();
  const Samples samples(reference, shown, needs_all ? std::ssize(names) : shown, scene.problem.end);
  const Path& path = samples.values();
  SampledSolution solution{.columns = columns_along(path, {names.begin(), names.begin() + shown},
                                                    [](double, In columns) -> Vec { return columns; }),
                           .bound = samples.bound(),
                           .energy = energy_along(scene, path),
                           .reactions = reactions_along(scene, path)};
  solution.motion = motion_along(scene, path, solution.columns.names);
  for (const auto& [t, value] : path) solution.t.push_back(rounded(t, digits_of_times));
  return solution;
}

}  // namespace fde::bench
