// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/observers/drift.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "fdebench/benchmarks/observers/comparison_steps.hpp"
#include "fdebench/benchmarks/observers/independent_memory.hpp"
#include "fdebench/benchmarks/text/rounded_number.hpp"

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

// The parabola through three points (time, value).
class Parabola {
 public:
  Parabola(const std::array<double, 3>& times, const std::array<double, 3>& values)
      : origin_(times[0]), second_(times[1]), value_(values[0]) {
    slope_ = (values[1] - values[0]) / (times[1] - times[0]);
    const double next = (values[2] - values[1]) / (times[2] - times[1]);
    bend_ = (next - slope_) / (times[2] - times[0]);
  }

  [[nodiscard]] double value(double t) const {
    return value_ + (t - origin_) * (slope_ + (t - second_) * bend_);
  }
  [[nodiscard]] double rate(double t) const { return slope_ + (2 * t - origin_ - second_) * bend_; }

 private:
  double origin_, second_, value_, slope_{}, bend_{};
};

// Simpson's rule, exact for cubics.
template <class Function>
double integral(double from, double to, const Function& f) {
  return (to - from) / 6 * (f(from) + 4 * f((from + to) / 2) + f(to));
}

constexpr int octaves = 10, digits = 3;
constexpr double between = 1.0 / 8.0;  // of an octave

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

EnergyObserver::Point EnergyObserver::point_at(double t, In columns) const {
  const auto size = std::ssize(energy_.differentiated_columns);
  Point point{t, energy_.value(columns), energy_.power(t, columns), Vec(size), Vec(size)};
  if (size == 0) return point;
  energy_.rate_coefficients(t, columns, point.rate_coefficients);
  for (Eigen::Index k = 0; k < size; ++k)
    point.differentiated_columns[k] = columns[energy_.differentiated_columns[static_cast<std::size_t>(k)]];
  return point;
}

void EnergyObserver::observe(double t, In columns) {
  std::rotate(last_.begin(), last_.begin() + 1, last_.end());
  last_[2] = point_at(t, columns);
  if (step_count_++ == 0) start_ = last_[2].energy;
  if (step_count_ < 3) return;

  // In units of the time between the three steps, whose square may overflow.
  const double unit = last_[2].t - last_[0].t;
  const auto place = [&](const Point& at) { return (at.t - last_[0].t) / unit; };
  const auto parabola = [&](const auto& of) {
    return Parabola({0.0, place(last_[1]), 1.0}, {of(last_[0]), of(last_[1]), of(last_[2])});
  };
  const Parabola power = parabola([](const Point& at) { return at.power; });
  const auto add = [&](const Point& from, const Point& to) {
    work_.add(0, unit * integral(place(from), place(to), [&](double at) { return power.value(at); }));
    for (Eigen::Index k = 0; k < from.differentiated_columns.size(); ++k) {
      const Parabola share = parabola([k](const Point& at) { return at.rate_coefficients[k]; });
      const Parabola rated = parabola([k](const Point& at) { return at.differentiated_columns[k]; });
      work_.add(
          0, integral(place(from), place(to), [&](double at) { return share.value(at) * rated.rate(at); }));
    }
    compare(to);
  };
  if (step_count_ == 3) add(last_[0], last_[1]);
  add(last_[1], last_[2]);
}

void EnergyObserver::compare(const Point& at) {
  const double off = std::abs(at.energy - start_ - work_[0]);
  if (!(off <= largest_)) largest_ = off;  // also if it is NaN
}

std::optional<double> EnergyObserver::residual() const {
  if (step_count_ < 3) return std::nullopt;
  return largest_;
}

RunningMaximum::RunningMaximum(double end) : next_(std::ldexp(end, -octaves)) {}

void RunningMaximum::observe(double t, double value) {
  constexpr double rounding = 1e-12;
  largest_ = std::max(largest_, value);
  if (t < next_ * (1.0 - rounding)) return;
  if (largest_ > 0.0 && std::isfinite(largest_)) add(rounded(t, digits), rounded(largest_, digits));
  while (next_ * (1.0 - rounding) <= t) next_ *= std::exp2(between);
}

// Two times next to each other may be the same to three digits. Of equal values the first and the last are
// kept, which suffice to draw them.
void RunningMaximum::add(double t, double value) {
  auto& [times, values] = course_;
  const auto count = values.size();
  const bool is_level = count > 1 && values[count - 1] == value && values[count - 2] == value;
  if (count > 0 && (is_level || t <= times.back())) {
    times.back() = std::max(times.back(), t);
    values.back() = value;
  } else {
    times.push_back(t);
    values.push_back(value);
  }
}

}  // namespace fde::bench
