// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/sampled_function.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fde::bench {
namespace {

// The second derivatives of the not-a-knot spline at the samples: with the lengths h_i between samples and
// the slopes d_i of the lines through both,
//   h_(i-1) M_(i-1) + 2 (h_(i-1) + h_i) M_i + h_i M_(i+1) = 6 (d_i - d_(i-1)),
// where M_0, and M_n alike, are on the line through the next two. The matrix is diagonally dominant.
std::vector<double> spline_curvatures(const std::vector<double>& x, const std::vector<double>& u) {
  const std::size_t n = x.size() - 1;
  const auto h = [&](std::size_t i) { return static_cast<long double>(x[i + 1]) - x[i]; };
  const auto slope = [&](std::size_t i) { return (static_cast<long double>(u[i + 1]) - u[i]) / h(i); };
  std::vector<long double> diagonal(n + 1), above(n + 1), m(n + 1);
  for (std::size_t i = 1; i < n; ++i) {
    long double below = h(i - 1);
    diagonal[i] = 2.0L * (h(i - 1) + h(i));
    above[i] = h(i);
    m[i] = 6.0L * (slope(i) - slope(i - 1));
    if (i == 1) {
      const long double ratio = h(0) / h(1);
      diagonal[1] += h(0) * (1.0L + ratio);
      above[1] -= h(0) * ratio;
    }
    if (i == n - 1) {
      const long double ratio = h(n - 1) / h(n - 2);
      diagonal[i] += h(n - 1) * (1.0L + ratio);
      below -= h(n - 1) * ratio;
    }
    if (i == 1) continue;
    const long double factor = below / diagonal[i - 1];
    diagonal[i] -= factor * above[i - 1];
    m[i] -= factor * m[i - 1];
  }
  for (std::size_t i = n - 1; i > 0; --i)
    m[i] = (m[i] - (i < n - 1 ? above[i] * m[i + 1] : 0.0L)) / diagonal[i];
  m[0] = m[1] + (m[1] - m[2]) * h(0) / h(1);
  m[n] = m[n - 1] + (m[n - 1] - m[n - 2]) * h(n - 1) / h(n - 2);
  return {m.begin(), m.end()};
}

std::shared_ptr<const std::vector<double>> shared(std::vector<double> values) {
  return std::make_shared<const std::vector<double>>(std::move(values));
}

}  // namespace

SampledFunction::Pointer SampledFunction::through(std::string name, std::string source, Interpolation between,
                                                  std::vector<double> arguments, std::vector<double> values) {
  SampledFunction function;
  function.name_ = std::move(name);
  function.source_ = std::move(source);
  function.between_ = between;
  if (between == Interpolation::cubic) function.curvatures_ = shared(spline_curvatures(arguments, values));
  function.arguments_ = shared(std::move(arguments));
  function.values_ = shared(std::move(values));
  function.tabulate();
  function.find_breaks();
  function.derivative_ = derivative_of(function);
  return std::make_shared<const SampledFunction>(std::move(function));
}

SampledFunction::Pointer SampledFunction::derivative_of(const SampledFunction& function) {
  if (function.degree() == 0) return nullptr;
  SampledFunction slope = function;
  slope.name_ += "'";
  ++slope.order_;
  slope.tabulate();
  slope.derivative_ = derivative_of(slope);
  return std::make_shared<const SampledFunction>(std::move(slope));
}

int SampledFunction::degree() const {
  const int of_samples = between_ == Interpolation::constant ? 0 : between_ == Interpolation::linear ? 1 : 3;
  return of_samples - order_;
}

std::size_t SampledFunction::pieces() const {
  return arguments_->size() - (between_ == Interpolation::constant ? 0 : 1);
}

void SampledFunction::tabulate() {
  coefficients_.clear();
  for (std::size_t i = 0; i < pieces(); ++i) {
    for (const long double c :
         coefficients(i, [](double sample) { return static_cast<long double>(sample); }))
      coefficients_.push_back(static_cast<double>(c));
  }
}

std::span<const double> SampledFunction::tabulated(std::size_t piece) const {
  const auto count = static_cast<std::size_t>(degree()) + 1;
  return std::span(coefficients_).subspan(piece * count, count);
}

// Where the highest coefficient changes by more than the rounding of the values.
void SampledFunction::find_breaks() {
  constexpr double few = 8.0 * std::numeric_limits<double>::epsilon();
  std::vector<double> breaks;
  for (std::size_t i = 1; i < pieces(); ++i) {
    const auto& u = *values_;
    double rounding = 0.0;
    if (degree() > 0) {
      const double shortest = std::min(start(i) - start(i - 1), (*arguments_)[i + 1] - start(i));
      const double size = std::max({std::abs(u[i - 1]), std::abs(u[i]), std::abs(u[i + 1])});
      rounding = few * size / std::pow(shortest, degree());
    }
    if (std::abs(tabulated(i).back() - tabulated(i - 1).back()) > rounding) breaks.push_back(start(i));
  }
  breaks_ = shared(std::move(breaks));
}

bool SampledFunction::is_smooth_at(double x) const { return !std::ranges::binary_search(*breaks_, x); }

SampledFunction::Pointer SampledFunction::alternation() const {
  std::vector<double> arguments{first()}, values{-1.0};
  for (std::size_t i = 0; i < breaks_->size(); ++i) {
    const double here = (*breaks_)[i], next = i + 1 < breaks_->size() ? (*breaks_)[i + 1] : last();
    arguments.push_back(here);
    values.push_back(0.0);
    if (next == here) break;  // a jump at the last sample
    arguments.push_back(i + 1 < breaks_->size() ? here + (next - here) / 2.0 : next);
    values.push_back(i % 2 == 0 ? 1.0 : -1.0);
  }
  if (arguments.size() == 1) {
    arguments.push_back(last());
    values.push_back(-1.0);
  }
  return through(name_, source_, Interpolation::linear, std::move(arguments), std::move(values));
}

// Of both values and of the second derivatives, which differences cancel, in the unit of this derivative.
double SampledFunction::coefficient_size(std::size_t piece) const {
  if (between_ == Interpolation::constant) return 0.0;
  constexpr double few = 4.0;
  const double h = (*arguments_)[piece + 1] - start(piece);
  const auto both = [&](const Shared& of) { return std::abs((*of)[piece]) + std::abs((*of)[piece + 1]); };
  return few * (both(values_) + (curvatures_ ? h * h * both(curvatures_) : 0.0)) / std::pow(h, order_);
}

double SampledFunction::margin() const {
  constexpr double part = 1e-9;
  return part * std::max(std::abs(first()), std::abs(last()));
}

bool SampledFunction::contains(double x) const { return x >= first() - margin() && x <= last() + margin(); }

// Equally spaced samples are found at once, others by bisection.
std::size_t SampledFunction::piece_at(double x) const {
  const auto& from = *arguments_;
  const std::size_t count = pieces();
  const double part = (x - first()) / (last() - first()) * static_cast<double>(from.size() - 1);
  const auto guess = std::min(static_cast<std::size_t>(std::max(part, 0.0)), count - 1);
  if (from[guess] <= x && (guess + 1 == count || x < from[guess + 1])) return guess;
  const auto after = std::upper_bound(from.begin() + 1, from.begin() + static_cast<std::ptrdiff_t>(count), x);
  return static_cast<std::size_t>(after - from.begin()) - 1;
}

double SampledFunction::at(double x) const {
  if (!contains(x)) return std::numeric_limits<double>::quiet_NaN();
  const std::size_t piece = piece_at(x);
  const auto taylor = tabulated(piece);
  const double offset = x - start(piece);
  double value = taylor.back();
  for (std::size_t k = taylor.size() - 1; k-- > 0;) value = value * offset + taylor[k];
  return value;
}

Interval SampledFunction::range_on(std::size_t piece, const Interval& x) const {
  const auto taylor = coefficients(piece, [](double sample) { return Interval(sample); });
  const Interval offset = x - Interval(start(piece));
  Interval value = taylor.back();
  for (std::size_t k = taylor.size() - 1; k-- > 0;) value = value * offset + taylor[k];
  return value;
}

Interval SampledFunction::at(const Interval& x) const {
  const double low = std::max(x.low, first() - margin()), high = std::min(x.high, last() + margin());
  if (!(low <= high)) return Interval::all();
  const std::size_t begin = piece_at(low), end = piece_at(high);
  Interval all{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t piece = begin; piece <= end; ++piece) {
    const Interval values =
        range_on(piece, {piece == begin ? low : start(piece), piece == end ? high : start(piece + 1)});
    all = {std::min(all.low, values.low), std::max(all.high, values.high)};
  }
  return all;
}

}  // namespace fde::bench
