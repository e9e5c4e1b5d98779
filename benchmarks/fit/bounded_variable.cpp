// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/fit/bounded_variable.hpp"

#include <algorithm>
#include <cmath>

namespace fde::bench {

bool BoundedVariable::has_low() const { return range_.low > Range().low; }
bool BoundedVariable::has_high() const { return range_.high < Range().high; }

bool BoundedVariable::has_inside(double theta) const {
  return std::isfinite(theta) && (!has_low() || theta > range_.low) && (!has_high() || theta < range_.high);
}

double BoundedVariable::free(double theta) const {
  if (has_low() && has_high()) return std::log((theta - range_.low) / (range_.high - theta));
  if (has_low()) return std::log((theta - range_.low) / unit_);
  return has_high() ? -std::log((range_.high - theta) / unit_) : theta / unit_;
}

double BoundedVariable::bounded(double z) const {
  if (has_low() && has_high()) return range_.low + (range_.high - range_.low) / (1.0 + std::exp(-z));
  if (has_low()) return range_.low + unit_ * std::exp(z);
  return has_high() ? range_.high - unit_ * std::exp(-z) : unit_ * z;
}

double BoundedVariable::slope(double z) const {
  if (has_low() && has_high()) {
    const double part = 1.0 / (1.0 + std::exp(-z));
    return (range_.high - range_.low) * part * (1.0 - part);
  }
  if (has_low()) return unit_ * std::exp(z);
  return unit_ * (has_high() ? std::exp(-z) : 1.0);
}

double BoundedVariable::nearest_end(double theta) const {
  constexpr double inside = 1e-9;
  const bool is_low = has_low() && (!has_high() || theta - range_.low < range_.high - theta);
  if (is_low) return range_.open_low ? range_.low + inside * width() : range_.low;
  return range_.open_high ? range_.high - inside * width() : range_.high;
}

double BoundedVariable::width() const {
  return has_low() && has_high() ? std::min(range_.high - range_.low, unit_) : unit_;
}

}  // namespace fde::bench
