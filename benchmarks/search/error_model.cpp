#include "search/error_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fde {
namespace {

constexpr std::size_t most_fitted = 5;
constexpr double least_power = 0.05, most_power = 8.0, power_step = 0.05;
constexpr double least_gap = 0.2, most_gap = 3.0, gap_step = 0.2;

// What a curve may miss beside what the best one misses: errors are no exact sums of two powers.
constexpr double tolerated = 0.01;

// The errors with their steps relative to the finest, coarsest first.
struct Point {
  double n, error;
};
std::vector<Point> points_of(std::span<const ErrorWith> measured) {
  std::vector<Point> points;
  for (const auto& [steps, error] : measured.last(std::min(measured.size(), most_fitted))) {
    if (error > 0.0 && std::isfinite(error))
      points.push_back({static_cast<double>(steps) / measured.back().steps, error});
  }
  return points;
}

// The a and b with the least sum of (a n^-p / e + b n^-q / e - 1)^2.
struct Coefficients {
  double a = 0.0, b = 0.0;
};
Coefficients fitted(const std::vector<Point>& points, double p, double q) {
  double uu = 0.0, uv = 0.0, vv = 0.0, u1 = 0.0, v1 = 0.0;
  for (const auto& [n, error] : points) {
    const double u = std::pow(n, -p) / error, v = std::pow(n, -q) / error;
    uu += u * u;
    uv += u * v;
    vv += v * v;
    u1 += u;
    v1 += v;
  }
  if (points.size() < 3) return {u1 / uu, 0.0};
  const double determinant = uu * vv - uv * uv;
  return {(u1 * vv - v1 * uv) / determinant, (uu * v1 - uv * u1) / determinant};
}

}  // namespace

double ErrorModel::Curve::at(double n) const { return a * std::pow(n, -p) + b * std::pow(n, -q); }

ErrorModel::ErrorModel(std::span<const ErrorWith> measured) {
  const auto points = points_of(measured);
  if (points.size() < 2) return;
  scale_ = measured.back().steps;
  double best = std::numeric_limits<double>::infinity();
  for (double p = least_power; p <= most_power; p += power_step) {
    for (double gap = least_gap; gap <= most_gap; gap += gap_step) {
      const auto [a, b] = fitted(points, p, p + gap);
      Curve curve{.p = p, .q = p + gap, .a = a, .b = b};
      if (!(a > 0.0) || !(a + b > 0.0)) continue;  // not an error beyond the finest
      for (const auto& [n, error] : points) curve.misfit += std::pow(curve.at(n) / error - 1.0, 2);
      curve.misfit = std::sqrt(curve.misfit / static_cast<double>(points.size()));
      best = std::min(best, curve.misfit);
      curves_.push_back(curve);
      if (points.size() < 3) break;  // one power
    }
  }
  std::erase_if(curves_, [&](const Curve& curve) { return curve.misfit > 2.0 * best + tolerated; });
  best_ = static_cast<std::size_t>(std::ranges::min_element(curves_, {}, &Curve::misfit) - curves_.begin());
}

Expected ErrorModel::error(double steps) const {
  Expected error{.value = curves_[best_].at(steps / scale_)};
  error.low = error.high = error.value;
  for (const Curve& curve : curves_) {
    const double other = curve.at(steps / scale_);
    error.low = std::min(error.low, other);
    error.high = std::max(error.high, other);
  }
  return error;
}

double ErrorModel::steps_of(const Curve& curve, double error) const {
  constexpr double most = 1e30;
  double few = 1.0, many = 1.0;  // relative to scale_
  while (many < most && curve.at(many) > error) many *= 2.0;
  while (few > 1.0 / scale_ && curve.at(few) <= error) few /= 2.0;
  for (int i = 0; i < 60 && many > few * (1.0 + 1e-6); ++i) {
    const double middle = std::sqrt(few * many);
    (curve.at(middle) > error ? few : many) = middle;
  }
  return std::ceil(many * scale_);
}

Expected ErrorModel::steps(double error) const {
  Expected steps{.value = steps_of(curves_[best_], error)};
  steps.low = steps.high = steps.value;
  for (const Curve& curve : curves_) {
    const double other = steps_of(curve, error);
    steps.low = std::min(steps.low, other);
    steps.high = std::max(steps.high, other);
  }
  return steps;
}

}  // namespace fde
