// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/sampled_solution.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <queue>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/text/rounded_number.hpp"

namespace fde::bench {
namespace {

constexpr int first_times = 120;
constexpr double allowed = 0.004;     // distance of curve and polyline, as a fraction of a column's range
constexpr double least_width = 1e-5;  // of an interval that is divided, as a fraction of the end
constexpr int digits_of_times = 7;    // resolve a third of least_width, so that rounded times increase
constexpr int digits_of_values = 4;
constexpr double last_digit = 1e-4;

// The first `kept` columns at adaptively chosen times, dense where one of the first `columns` is curved.
class Samples {
 public:
  Samples(const Scene& scene, const reference::Reference& reference, Eigen::Index columns, Eigen::Index kept,
          std::ptrdiff_t most_times)
      : reference_(reference), columns_(columns), kept_(kept), end_(scene.problem.end) {
    for (int i = 0; i <= first_times; ++i) add(end_ * i / first_times);
    for (const double jump : scene.problem.jump_times)
      if (is_apart(jump)) add(jump);
    for (auto left = values_.begin(); std::next(left) != values_.end(); ++left) wait(left, unknown);
    while (!waiting_.empty() && std::ssize(values_) < most_times) divide_worst();
  }

  [[nodiscard]] const std::map<double, Vec>& values() const { return values_; }
  [[nodiscard]] double bound() const { return bound_; }

 private:
  using Place = std::map<double, Vec>::iterator;
  using Sample = std::map<double, Vec>::value_type;
  static constexpr double unknown = std::numeric_limits<double>::infinity();

  Place add(double t) {
    const auto [value, bounds] = reference_.at(t);
    if (!value.allFinite() || !bounds.allFinite()) throw std::runtime_error("no value");
    if (bounds.size() > 0) bound_ = std::max(bound_, bounds.maxCoeff());
    low_ = values_.empty() ? value : Vec(low_.cwiseMin(value));
    high_ = values_.empty() ? value : Vec(high_.cwiseMax(value));
    return values_.insert_or_assign(t, value.head(kept_)).first;
  }

  // Whether the times before and after are different in the digits that are kept.
  [[nodiscard]] bool is_apart(double t) const {
    const auto next = values_.upper_bound(t);
    return next != values_.end() && next->first - t > least_width * end_ &&
           t - std::prev(next)->first > least_width * end_;
  }

  // The interval after `left` is to be divided. `away`: how far its polyline is off as a part of what is
  // allowed, by what is known of the interval that it is part of.
  void wait(Place left, double away) {
    if (std::next(left)->first - left->first >= least_width * end_) waiting_.emplace(away, left);
  }

  // Not in the middle, where an oscillation may be as at both ends; that one value is on the polyline may be
  // chance, so a second one decides.
  void divide_worst() {
    constexpr double part = 0.382, other_part = 0.71;
    const auto left = waiting_.top().second, right = std::next(left);
    waiting_.pop();
    const auto middle = add(std::lerp(left->first, right->first, part));
    double away = distance(*left, *right, part, middle->second);
    if (away <= 1.0) {
      const auto other = reference_.at(std::lerp(left->first, right->first, other_part)).value;
      away = distance(*left, *right, other_part, other.head(kept_));
    }
    if (away <= 1.0) return;
    wait(left, away);
    wait(middle, away);
  }

  // How far a value between two is off their polyline, as a part of what is allowed: at least the last digit
  // that is kept, below which there is noise only.
  [[nodiscard]] double distance(const Sample& left, const Sample& right, double part,
                                const Vec& value) const {
    const Vec off = (value - (1.0 - part) * left.second - part * right.second).head(columns_).cwiseAbs();
    double worst = 0.0;
    for (Eigen::Index i = 0; i < off.size(); ++i) {
      const double size = std::max(std::abs(high_[i]), std::abs(low_[i]));
      const double most = std::max(allowed * (high_[i] - low_[i]), last_digit * size);
      if (off[i] > 0.0) worst = std::max(worst, off[i] / most);
    }
    return worst;
  }

  // By how far they are off, of equal ones the first.
  struct IsLessUrgent {
    bool operator()(const std::pair<double, Place>& a, const std::pair<double, Place>& b) const {
      return a.first != b.first ? a.first < b.first : a.second->first > b.second->first;
    }
  };

  const reference::Reference& reference_;
  Eigen::Index columns_, kept_;
  double end_, bound_ = 0.0;
  std::map<double, Vec> values_{};
  std::priority_queue<std::pair<double, Place>, std::vector<std::pair<double, Place>>, IsLessUrgent>
      waiting_{};
  Vec low_{}, high_{};  // of the values so far
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

SampledSolution sample_solution(const Scene& scene, const reference::Reference& reference,
                                const SampleLimits& limits) {
  const auto& names = scene.outputs.names;
  const auto shown = std::min<Eigen::Index>(std::ssize(names), limits.columns);
  const bool needs_all = scene.energy || scene.reactions || !scene.display_path.names.empty();
  const Samples samples(scene, reference, shown, needs_all ? std::ssize(names) : shown, limits.times);
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
