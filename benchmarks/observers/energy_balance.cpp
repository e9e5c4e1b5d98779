#include "observers/energy_balance.hpp"

#include <algorithm>
#include <cmath>

namespace fde {

void EnergyObserver::observe(double t, In y) {
  std::rotate(last_.begin(), last_.begin() + 1, last_.end());
  last_[2] = {t, energy_.value(y), energy_.power(t, y)};
  if (seen_++ == 0) start_ = last_[2].energy;
  if (seen_ < 3) return;

  // The parabola p0 + slope (t - t0) + bend (t - t0)(t - t1); Simpson's rule is exact for it.
  const auto& [first, second, third] = last_;
  const double slope = (second.power - first.power) / (second.t - first.t);
  const double next = (third.power - second.power) / (third.t - second.t);
  const double bend = (next - slope) / (third.t - first.t);
  const auto add = [&, &a = first, &b = second](const Point& from, const Point& to) {
    const double middle = (from.t + to.t) / 2;
    const double power = a.power + (middle - a.t) * (slope + (middle - b.t) * bend);
    work_.add(0, (to.t - from.t) / 6 * (from.power + 4 * power + to.power));
    compare(to);
  };
  if (seen_ == 3) add(first, second);
  add(second, third);
}

void EnergyObserver::compare(const Point& at) {
  const double off = std::abs(at.energy - start_ - work_[0]);
  if (!(off <= largest_)) largest_ = off;  // also when it is no number
}

std::optional<double> EnergyObserver::residual() const {
  if (seen_ < 3) return std::nullopt;
  return largest_;
}

}  // namespace fde
