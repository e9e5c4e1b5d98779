// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/reports/page/chart_number.hpp"
#include "fdebench/reports/page/page_data.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

constexpr int first_times = 120, most_times = 400;
constexpr double allowed = 0.004;         // distance of curve and polyline, as a fraction of a column's range
constexpr Eigen::Index most_columns = 8;  // a diffusion has hundreds
constexpr int digits = 4;

// The solution at adaptively chosen times, dense where one of the first `columns` columns is curved.
class Samples {
 public:
  Samples(const Scene& scene, Eigen::Index columns)
      : reference_(reference_of(scene)), columns_(columns), end_(scene.problem.end) {
    for (int i = 0; i <= first_times; ++i) add(end_ * i / first_times);
    const auto rows = values_.size();
    Vec low = values_.begin()->second, high = low;
    for (const auto& [t, value] : values_) low = low.cwiseMin(value), high = high.cwiseMax(value);
    range_ = (high - low).head(columns_);
    if (rows < 2) return;
    for (auto left = values_.begin(); std::next(left) != values_.end();) left = refined(left);
  }

  [[nodiscard]] const std::map<double, Vec>& values() const { return values_; }
  [[nodiscard]] double bound() const { return bound_; }

 private:
  using Place = std::map<double, Vec>::iterator;

  Place add(double t) {
    const auto [value, bounds] = reference_.at(t);
    if (!value.allFinite()) throw std::runtime_error("no value");
    if (bounds.size() > 0) bound_ = std::max(bound_, bounds.maxCoeff());
    return values_.insert_or_assign(t, value).first;
  }

  // Bisects the interval after `left` if its polyline is too coarse. Returns the left end of the next
  // interval to check.
  Place refined(Place left) {
    const auto right = std::next(left);
    const double width = right->first - left->first;
    if (std::ssize(values_) >= most_times || width < 1e-5 * end_) return right;
    const Vec between = 0.5 * (left->second + right->second);
    const auto middle = add(left->first + 0.5 * width);
    const Vec away = (middle->second - between).head(columns_).cwiseAbs() - allowed * range_;
    return away.maxCoeff() > 0.0 ? left : right;
  }

  reference::Reference reference_;
  Eigen::Index columns_;
  double end_, bound_ = 0.0;
  std::map<double, Vec> values_{};
  Vec range_{};
};

using Path = std::map<double, Vec>;

// Values along the path, one column per name; null where a value is not finite.
json columns_along(const Path& path, const std::vector<std::string>& names,
                   const std::function<Vec(double t, In columns)>& of) {
  std::vector<json> values(names.size(), json::array());
  for (const auto& [t, columns] : path) {
    const Vec at = of(t, columns);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const double value = at[static_cast<Eigen::Index>(i)];
      values[i].push_back(std::isfinite(value) ? json(rounded_for_chart(value, digits)) : json());
    }
  }
  return {{"columns", names}, {"values", values}};
}

// Adds the energy, unless it is constant.
void add_energy(json& shown, const Scene& scene, const Path& path) {
  if (!scene.energy) return;
  json energy = columns_along(
      path, {"energy"}, [&](double, In columns) { return Vec::Constant(1, scene.energy.value(columns)); });
  const auto& values = energy["values"][0];
  const bool kept = std::ranges::all_of(values, [&](const json& value) { return value == values.front(); });
  if (!kept) shown["energy"] = std::move(energy);
}

void add_reactions(json& shown, const Scene& scene, const Path& path) {
  const auto& reactions = scene.reactions;
  if (!reactions || !reactions.has_exact_multipliers()) return;
  const auto size = std::ssize(reactions.names);
  shown["reactions"] = columns_along(path, reactions.names, [&](double t, In columns) -> Vec {
    return exact_reactions(scene, t, columns).head(size);
  });
}

// Adds the coordinates of the motion; by name only if they are columns of the scene.
void add_motion(json& shown, const Scene& scene, const Path& path) {
  const auto& names = scene.display_path.names;
  if (names.empty()) return;
  const auto columns = shown["columns"].get<std::vector<std::string>>();
  const bool are_columns = std::ranges::all_of(
      names, [&](const std::string& name) { return std::ranges::find(columns, name) != columns.end(); });
  if (are_columns) {
    shown["motion"] = {{"columns", names}};
    return;
  }
  shown["motion"] = columns_along(
      path, names, [&](double t, In of_path) { return columns_at(scene.display_path, t, of_path); });
}

}  // namespace

json solution_of(const Scene& scene) {
  const auto shown = std::min<Eigen::Index>(std::ssize(scene.outputs.names), most_columns);
  const Samples samples(scene, shown);
  const auto& names = scene.outputs.names;
  json solution = columns_along(samples.values(), {names.begin(), names.begin() + shown},
                                [](double, In columns) -> Vec { return columns; });
  for (const auto& [t, value] : samples.values()) solution["t"].push_back(rounded_for_chart(t));
  solution["bound"] = samples.bound();
  add_energy(solution, scene, samples.values());
  add_reactions(solution, scene, samples.values());
  add_motion(solution, scene, samples.values());
  return solution;
}

json solution_of(const SceneSettings& settings) {
  const auto scene = known_scene(settings);
  if (!scene) return {};
  try {
    return solution_of(*scene);
  } catch (const std::exception&) {  // without a reference there is no chart
    return {};
  }
}

}  // namespace fde::bench
