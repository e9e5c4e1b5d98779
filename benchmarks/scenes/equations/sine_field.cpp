// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/equations/sine_field.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "fdebench/benchmarks/scenes/equations/sine_modes.hpp"
#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/history/parallel_for_rows.hpp"

namespace fde::bench {
namespace {

constexpr Eigen::Index most_sines = 8'000'000;  // stored for the maximum: 64 MB

// The values of each mode at the given points, one column a mode.
Matrix sines_at(const SineGrid& points, const std::vector<int>& places, Eigen::Index modes) {
  Matrix sines(std::ssize(places), modes);
  for (Eigen::Index k = 0; k < modes; ++k) {
    for (Eigen::Index i = 0; i < sines.rows(); ++i)
      sines(i, k) = points.sine(static_cast<int>(k) + 1, places[static_cast<std::size_t>(i)]);
  }
  return sines;
}

std::vector<int> all_places(const SineGrid& points) {
  std::vector<int> all(static_cast<std::size_t>(points.points));
  std::iota(all.begin(), all.end(), 1);
  return all;
}

}  // namespace

// Accumulates the terms of the solution at one time, at the points that are columns.
class SineField::Sum {
 public:
  explicit Sum(Eigen::Index shown) : at_points_(shown) {}

  // Adds the term of `count` modes with the same decay: their amplitude at t = 0, the decay factor, and the
  // sum of their values at the points.
  template <class Values>
  void add(double amplitude, const DecayFactor& part, double count, const Values& values) {
    const double term = amplitude * part.value;
    for (Eigen::Index i = 0; i < values.size(); ++i) at_points_.add(i, term * values[i]);
    squares_.add(0, count * term * term);
    // Amplitude and sines have a relative error of a few units of rounding.
    bound_ += count * std::abs(amplitude) * (part.bound + 32.0 * rounding_unit * std::abs(part.value));
  }

  // Norms are below the largest value: one bound holds for all columns. square_of_mode: the squared l2 norm
  // of a mode.
  [[nodiscard]] reference::ReferenceValue result(const std::optional<double>& square_of_mode,
                                                 const std::optional<double>& maximum) const {
    std::vector<double> columns;
    for (Eigen::Index i = 0; i < at_points_.size(); ++i) columns.push_back(at_points_[i]);
    if (square_of_mode) columns.push_back(std::sqrt(*square_of_mode * squares_[0]));
    if (maximum) columns.push_back(*maximum);
    const auto count = std::ssize(columns);
    return {Eigen::Map<const Vec>(columns.data(), count), Vec::Constant(count, bound_)};
  }

 private:
  RunningSums at_points_, squares_{1};
  double bound_ = 0.0;
};

SineField::SineField(SineGrid points, InitialField initial_values_on_axis, int dimensions, double order,
                     double diffusivity)
    : points_(points),
      start_(std::move(initial_values_on_axis)),
      shape_{points.points, dimensions},
      order_(order),
      diffusivity_(diffusivity),
      sines_(sines_at(points, output_points(shape_), start_.amplitudes.size())) {
  if (outputs_all_points(shape_) || points.points * start_.amplitudes.size() > most_sines) return;
  all_sines_ = sines_at(points, all_places(points), start_.amplitudes.size());
}

double SineField::coupling() const { return diffusivity_ * points_.intervals() * points_.intervals(); }

SparseMatrix SineField::matrix() const {
  const double c = coupling();
  const Vec beside = Vec::Constant(points_.points + 1, c);
  return five_point_matrix(shape_, beside, beside,
                           [&](Eigen::Index) { return -2.0 * shape_.dimensions * c; });
}

void SineField::apply(In u, Out f) const {
  parallel_for_rows(shape_.size(), 1, [&](Eigen::Index first, Eigen::Index count) {
    for (Eigen::Index end = first + count; first < end;) {
      const Eigen::Index of_line = std::min(end, (first / points_.points + 1) * points_.points) - first;
      apply_to_part_of_line(u, f, first, of_line);
      first += of_line;
    }
  });
}

void SineField::apply_to_part_of_line(In u, Out f, Eigen::Index first, Eigen::Index count) const {
  const Eigen::Index n = points_.points, start = first / n * n;
  const double c = coupling(), middle = -2.0 * shape_.dimensions;
  const Eigen::Index inner = std::max(first, start + 1),
                     inner_count = std::min(first + count, start + n - 1) - inner;
  if (first == start) f[start] = c * (middle * u[start] + u[start + 1]);
  if (inner_count > 0) {
    f.segment(inner, inner_count) =
        c * (u.segment(inner - 1, inner_count) + middle * u.segment(inner, inner_count) +
             u.segment(inner + 1, inner_count));
  }
  if (first + count == start + n) f[start + n - 1] = c * (u[start + n - 2] + middle * u[start + n - 1]);
  if (start > 0) f.segment(first, count) += c * u.segment(first - n, count);
  if (start + n < shape_.size()) f.segment(first, count) += c * u.segment(first + n, count);
}

Outputs SineField::outputs() const {
  return field_outputs(shape_, points_.intervals(), all_sines_.size() > 0);
}

reference::ReferenceValue SineField::exact_columns_at(double t) const {
  const bool line = shape_.dimensions == 1;
  const Eigen::Index modes = start_.amplitudes.size(), shown = sines_.rows();
  const auto rate = [&](Eigen::Index k) { return diffusivity_ * points_.rate(static_cast<int>(k) + 1); };
  Sum sum(line ? shown : shown * shown);
  Matrix left = Matrix::Zero(modes, line ? 1 : modes);  // the amplitudes at t
  for (Eigen::Index k = 0; k < modes; ++k) {
    const double of_x = start_.amplitudes[k];
    if (of_x == 0.0) continue;
    if (line) {
      const DecayFactor part = decay_factor(order_, rate(k), t);
      sum.add(of_x, part, 1.0, sines_.col(k));
      left(k, 0) = of_x * part.value;
      continue;
    }
    // Modes (k, l) and (l, k) decay alike.
    for (Eigen::Index l = 0; l <= k; ++l) {
      const double amplitude = of_x * start_.amplitudes[l];
      if (amplitude == 0.0) continue;
      Matrix both = sines_.col(l) * sines_.col(k).transpose();
      if (l < k) both += Matrix(both.transpose());
      const DecayFactor part = decay_factor(order_, rate(k) + rate(l), t);
      sum.add(amplitude, part, l < k ? 2.0 : 1.0, both.reshaped());
      left(k, l) = left(l, k) = amplitude * part.value;
    }
  }
  std::optional<double> square_of_mode, maximum;
  if (!outputs_all_points(shape_)) square_of_mode = line ? 0.5 : 0.25;
  if (all_sines_.size() > 0) maximum = largest(left);
  return sum.result(square_of_mode, maximum);
}

double SineField::largest(const Matrix& amplitudes) const {
  const Matrix half = all_sines_ * amplitudes;
  if (shape_.dimensions == 1) return half.lpNorm<Eigen::Infinity>();
  return (half * all_sines_.transpose()).lpNorm<Eigen::Infinity>();
}

}  // namespace fde::bench
