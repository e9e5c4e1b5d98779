// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/observers/energy_balance.hpp"

#include <algorithm>
#include <cmath>

namespace fde::bench {

namespace {

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

}  // namespace

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

}  // namespace fde::bench
