// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/error_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fdebench/benchmarks/observers/rate.hpp"

namespace fde::bench {
namespace {

constexpr std::size_t most_fitted = 5;
// The grid of powers, as multiples of power_step: p, and the gap q - p.
constexpr double power_step = 0.05;
constexpr std::size_t least_power = 1, most_power = 160, least_gap = 4, most_gap = 60, gap_step = 4;

// Misfit allowed beyond twice the best curve's: measured errors are no exact sums of two powers.
constexpr double tolerated = 0.01;

// The positive errors with N relative to the finest run, from coarse to fine.
struct Point {
  double n, error;
};
std::vector<Point> points_of(std::span<const TrialError> measured) {
  std::vector<Point> points;
  for (const auto& [steps, error] : measured.last(std::min(measured.size(), most_fitted))) {
    if (error > 0.0 && std::isfinite(error))
      points.push_back({static_cast<double>(steps) / measured.back().steps, error});
  }
  return points;
}

// n^-p / e at each point.
using Column = std::vector<double>;
std::vector<Column> columns_of(const std::vector<Point>& points) {
  std::vector<Column> columns(1);
  Column ratios;
  for (const auto& [n, error] : points) {
    columns.front().push_back(1.0 / error);
    ratios.push_back(std::pow(n, -power_step));
  }
  for (std::size_t k = 1; k <= most_power + most_gap; ++k) {
    columns.push_back(columns.back());
    for (std::size_t i = 0; i < ratios.size(); ++i) columns.back()[i] *= ratios[i];
  }
  return columns;
}

// Least squares: the a and b that minimise sum (a u + b v - 1)^2; b = 0 for fewer than 3 points.
struct Coefficients {
  double a = 0.0, b = 0.0;
};
Coefficients fitted(const Column& u, const Column& v) {
  double uu = 0.0, uv = 0.0, vv = 0.0, u1 = 0.0, v1 = 0.0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    uu += u[i] * u[i];
    uv += u[i] * v[i];
    vv += v[i] * v[i];
    u1 += u[i];
    v1 += v[i];
  }
  if (u.size() < 3) return {u1 / uu, 0.0};
  const double determinant = uu * vv - uv * uv;
  return {(u1 * vv - v1 * uv) / determinant, (uu * v1 - uv * u1) / determinant};
}

// Root mean square of a u + b v - 1.
double misfit_of(const Coefficients& with, const Column& u, const Column& v) {
  double sum = 0.0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double residual = with.a * u[i] + with.b * v[i] - 1.0;
    sum += residual * residual;
  }
  return std::sqrt(sum / static_cast<double>(u.size()));
}

}  // namespace

Prediction steps_beyond(int finest, Prediction steps) {
  for (double* of : {&steps.value, &steps.low, &steps.high}) *of = std::max(*of, finest + 1.0);
  return steps;
}

std::optional<double> observed_rate(std::span<const TrialError> measured) {
  std::vector<ErrorSample> points;
  for (const auto& [steps, error] : measured.last(std::min(measured.size(), most_fitted)))
    points.push_back({1.0 / steps, error});
  const Fit fit = fit_rate(points);
  return fit.points > 0 ? std::optional(fit.slope) : std::nullopt;
}

double ErrorModel::Curve::at(double x) const { return a * std::exp(-p * x) + b * std::exp(-q * x); }

ErrorModel::ErrorModel(std::span<const TrialError> measured) {
  const auto points = points_of(measured);
  if (points.size() < 2) return;
  scale_ = measured.back().steps;
  const auto columns = columns_of(points);
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t p = least_power; p <= most_power; ++p) {
    for (std::size_t gap = least_gap; gap <= most_gap; gap += gap_step) {
      const auto with = fitted(columns[p], columns[p + gap]);
      if (!(with.a > 0.0) || !(with.a + with.b > 0.0)) continue;  // not positive for all N > scale_
      const double misfit = misfit_of(with, columns[p], columns[p + gap]);
      best = std::min(best, misfit);
      curves_.push_back({.p = power_step * static_cast<double>(p),
                         .q = power_step * static_cast<double>(p + gap),
                         .a = with.a,
                         .b = with.b,
                         .misfit = misfit});
      if (points.size() < 3) break;  // b = 0: q does not matter
    }
  }
  std::erase_if(curves_, [&](const Curve& curve) { return curve.misfit > 2.0 * best + tolerated; });
  best_ = static_cast<std::size_t>(std::ranges::min_element(curves_, {}, &Curve::misfit) - curves_.begin());
}

Prediction ErrorModel::error(double steps) const {
  const double x = std::log(steps / scale_);
  Prediction error{.value = curves_[best_].at(x)};
  error.low = error.high = error.value;
  for (const Curve& curve : curves_) {
    const double other = curve.at(x);
    error.low = std::min(error.low, other);
    error.high = std::max(error.high, other);
  }
  return error;
}

// Newton's method in log N and log e, where a curve is nearly straight, safeguarded by a bracket.
double ErrorModel::steps_of(const Curve& curve, double error) const {
  constexpr double most = 70.0, stride = 3.5, close = 1e-6;
  constexpr int most_steps = 60;
  double few = 0.0, many = 0.0;  // logarithms of N / scale_
  while (many < most && curve.at(many) > error) few = std::exchange(many, many + stride);
  while (few > -std::log(scale_) && curve.at(few) <= error) many = std::exchange(few, few - stride);
  double x = many;
  for (int i = 0; i < most_steps && many > few + close; ++i) {
    const double first = curve.a * std::exp(-curve.p * x), second = curve.b * std::exp(-curve.q * x);
    const double value = first + second, slope = -(curve.p * first + curve.q * second) / value;
    (value > error ? few : many) = x;
    const double next = x + std::log(error / value) / slope + 0.1 * close;
    x = slope < 0.0 && next > few && next < many ? next : 0.5 * (few + many);
  }
  return std::ceil(std::exp(many) * scale_);
}

double ErrorModel::likely_steps(double error) const { return steps_of(curves_[best_], error); }

Prediction ErrorModel::steps(double error) const {
  Prediction steps{.value = likely_steps(error)};
  steps.low = steps.high = steps.value;
  for (const Curve& curve : curves_) {
    const double other = steps_of(curve, error);
    steps.low = std::min(steps.low, other);
    steps.high = std::max(steps.high, other);
  }
  return steps;
}

}  // namespace fde::bench
