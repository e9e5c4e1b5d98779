// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/observers/drift.hpp"

#include <cmath>

#include "fdebench/benchmarks/observers/comparison_steps.hpp"
#include "fdebench/benchmarks/observers/independent_memory.hpp"

namespace fde::bench {
namespace {

constexpr int most_looked_at = 256;

Drift drift_of(const DriftGrowth& course) { return {course.largest(), course.growth()}; }

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
    : scene_(scene), internal_(scene.problem.end) {
  if (scene.memory_columns.empty() || !grid || !grid->uniform() ||
      grid->steps < IndependentMemoryRule::fewest_steps)
    return;
  grid_ = grid;
  evaluated_steps_ = comparison_steps(grid->steps, most_looked_at);
  velocities_.resize(grid->steps + 1, std::ssize(scene.memory_columns));
}

void DriftObserver::observe(double t, In columns) {
  internal_.observe(t, scene_.constraint.drift(t, columns));
  if (grid_ && t != grid_->time(step_count_)) grid_.reset();  // the step sizes are not those of the grid
  if (!grid_) return;
  const int n = step_count_++;
  for (std::size_t m = 0; m < scene_.memory_columns.size(); ++m)
    velocities_(n, static_cast<Eigen::Index>(m)) = columns[scene_.memory_columns[m].velocity];
  if (columns_.size() < evaluated_steps_.size() && n == evaluated_steps_[columns_.size()])
    columns_.emplace_back(columns);
}

Drift DriftObserver::internal() const { return drift_of(internal_); }

std::optional<Drift> DriftObserver::independent() const {
  if (!grid_ || step_count_ <= grid_->steps) return std::nullopt;
  auto columns = columns_;
  for (std::size_t m = 0; m < scene_.memory_columns.size(); ++m) {
    const auto& [derivative, velocity, order, powers] = scene_.memory_columns[m];
    const IndependentMemoryRule memory(*grid_, order, powers);
    const Vec velocities = velocities_.col(static_cast<Eigen::Index>(m));
    for (std::size_t c = 1; c < columns.size(); ++c)
      columns[c][derivative] = memory.at(evaluated_steps_[c], velocities);
  }
  DriftGrowth course(grid_->end);
  for (std::size_t c = 1; c < columns.size(); ++c) {
    const double t = grid_->time(evaluated_steps_[c]);
    course.observe(t, scene_.constraint.drift(t, columns[c]));
  }
  return drift_of(course);
}

}  // namespace fde::bench
