// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/observers/drift.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "fdebench/benchmarks/observers/comparison_steps.hpp"
#include "fdebench/benchmarks/observers/independent_memory.hpp"

namespace fde::bench {
namespace {

constexpr int most_looked_at = 256;

// The steps of the growth, and with them steps at eight times per factor of 2 in t.
std::vector<int> steps_to_evaluate(int steps) {
  std::vector<int> octaves, all;
  for (int n = 1; n < steps; n = std::max(n + 1, static_cast<int>(std::ceil(n * std::exp2(1.0 / 8.0)))))
    octaves.push_back(n);
  std::ranges::set_union(comparison_steps(steps, most_looked_at), octaves, std::back_inserter(all));
  return all;
}

}  // namespace

void DriftGrowth::observe(double t, double drift) {
  if (!(drift <= largest_) && !std::isnan(largest_)) largest_ = drift;  // also if it is NaN
  if (t < next_) return;
  course_.push_back({t, largest_});
  while (next_ <= t) next_ *= std::exp2(1.0 / 16.0);
}

std::optional<double> DriftGrowth::growth() const {
  const Fit fit = fit_rate(course_);
  if (fit.points == 0) return std::nullopt;
  return fit.slope;
}

DriftObserver::DriftObserver(const Scene& scene, const std::optional<Grid>& grid)
    : scene_(scene), internal_(scene.problem.end), internal_course_(scene.problem.end) {
  if (scene.memory_columns.empty() || !grid || !grid->uniform() ||
      grid->steps < IndependentMemoryRule::fewest_steps)
    return;
  grid_ = grid;
  evaluated_steps_ = steps_to_evaluate(grid->steps);
  velocities_.resize(grid->steps + 1, std::ssize(scene.memory_columns));
}

void DriftObserver::observe(double t, In columns) {
  const double drift = scene_.constraint.drift(t, columns);
  internal_.observe(t, drift);
  if (t > 0.0) internal_course_.observe(t, drift);
  if (grid_ && t != grid_->time(step_count_)) grid_.reset();  // the step sizes are not those of the grid
  if (!grid_) return;
  const int n = step_count_++;
  for (std::size_t m = 0; m < scene_.memory_columns.size(); ++m)
    velocities_(n, static_cast<Eigen::Index>(m)) = columns[scene_.memory_columns[m].velocity];
  if (columns_.size() < evaluated_steps_.size() && n == evaluated_steps_[columns_.size()])
    columns_.emplace_back(columns);
}

Drift DriftObserver::internal() const {
  return {internal_.largest(), internal_.growth(), is_independent() ? Course{} : internal_course_.course()};
}

std::optional<Drift> DriftObserver::independent() const {
  if (!is_independent()) return std::nullopt;
  auto columns = columns_;
  for (std::size_t m = 0; m < scene_.memory_columns.size(); ++m) {
    const auto& [derivative, velocity, order, powers] = scene_.memory_columns[m];
    const IndependentMemoryRule memory(*grid_, order, powers);
    const Vec velocities = velocities_.col(static_cast<Eigen::Index>(m));
    for (std::size_t c = 1; c < columns.size(); ++c)
      columns[c][derivative] = memory.at(evaluated_steps_[c], velocities);
  }
  const auto steps_of_growth = comparison_steps(grid_->steps, most_looked_at);
  DriftGrowth growth(grid_->end);
  RunningMaximum course(grid_->end);
  for (std::size_t c = 1; c < columns.size(); ++c) {
    const int n = evaluated_steps_[c];
    const double t = grid_->time(n), drift = scene_.constraint.drift(t, columns[c]);
    if (std::ranges::binary_search(steps_of_growth, n)) growth.observe(t, drift);
    course.observe(t, drift);
  }
  return Drift{growth.largest(), growth.growth(), course.course()};
}

}  // namespace fde::bench
