// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/equations/variable_coefficient_field.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <utility>

#include "fdebench/benchmarks/scenes/equations/sine_modes.hpp"

namespace fde::bench {

namespace {

using LongVec = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

constexpr double most_work = 500.0 * 500.0 * 500.0;  // limit of points^3 times the modes in y

}  // namespace

VariableCoefficientField::VariableCoefficientField(SineGrid points, InitialField initial_values_on_axis,
                                                   int dimensions, double order, double diffusivity,
                                                   const Medium& medium)
    : points_(points),
      start_(std::move(initial_values_on_axis)),
      shape_{points.points, dimensions},
      order_(order),
      x_coupling_(points.points + 1),
      y_coupling_(dimensions == 1 ? 0 : points.points) {
  const double intervals = points.intervals(), scale = diffusivity * intervals * intervals;
  for (Eigen::Index i = 0; i < x_coupling_.size(); ++i)
    x_coupling_[i] = scale * medium.at((static_cast<double>(i) + 0.5) / intervals);
  for (Eigen::Index i = 0; i < y_coupling_.size(); ++i)
    y_coupling_[i] = scale * medium.at((static_cast<double>(i) + 1.0) / intervals);
  diagonal_ = -(x_coupling_.head(points.points) + x_coupling_.tail(points.points));
  if (dimensions > 1) diagonal_ -= 2.0 * y_coupling_;
}

SparseMatrix VariableCoefficientField::matrix() const {
  return five_point_matrix(shape_, x_coupling_, y_coupling_,
                           [&](Eigen::Index place) { return diagonal_[place % points_.points]; });
}

void VariableCoefficientField::apply(In u, Out f) const {
  const Eigen::Index n = points_.points, lines = shape_.size() / n;
  for (Eigen::Index j = 0; j < lines; ++j) {
    const auto own = u.segment(j * n, n);
    auto line = f.segment(j * n, n);
    line = diagonal_.cwiseProduct(own);
    line.tail(n - 1) += x_coupling_.segment(1, n - 1).cwiseProduct(own.head(n - 1));
    line.head(n - 1) += x_coupling_.segment(1, n - 1).cwiseProduct(own.tail(n - 1));
    if (j > 0) line += y_coupling_.cwiseProduct(u.segment((j - 1) * n, n));
    if (j + 1 < lines) line += y_coupling_.cwiseProduct(u.segment((j + 1) * n, n));
  }
}

Outputs VariableCoefficientField::outputs() const { return field_outputs(shape_, points_.intervals(), true); }

bool VariableCoefficientField::has_exact_solution() const {
  const auto modes_of_y = shape_.dimensions == 1 ? 1 : (start_.amplitudes.array() != 0.0).count();
  return std::pow(points_.points, 3) * static_cast<double>(modes_of_y) <= most_work;
}

// Computed in extended precision, because the smallest rates need full double accuracy, and the rates range
// from 10 to 10^6.
VariableCoefficientField::Modes VariableCoefficientField::modes_of(int of_y) const {
  const Eigen::Index n = points_.points;
  LongVec diagonal = diagonal_.cast<long double>();
  if (of_y > 0) {
    const long double angle = std::numbers::pi_v<long double> * of_y / (points_.points + 1.0L);
    diagonal += 2.0L * std::cos(angle) * y_coupling_.cast<long double>();
  }
  const LongVec beside = x_coupling_.segment(1, n - 1).cast<long double>();
  Eigen::SelfAdjointEigenSolver<LongMatrix> solver;
  solver.computeFromTridiagonal(diagonal, beside);
  const LongMatrix& vectors = solver.eigenvectors();
  LongMatrix residuals = diagonal.asDiagonal() * vectors;
  residuals.topRows(n - 1) += beside.asDiagonal() * vectors.bottomRows(n - 1);
  residuals.bottomRows(n - 1) += beside.asDiagonal() * vectors.topRows(n - 1);
  residuals -= vectors * solver.eigenvalues().asDiagonal();
  const LongVec start = start_.values.cast<long double>(), amplitudes = vectors.transpose() * start;
  return {.of_y = of_y,
          .amplitude_of_y = of_y > 0 ? start_.amplitudes[of_y - 1] : 1.0,
          .rates = -solver.eigenvalues().cast<double>(),
          .amplitudes = amplitudes.cast<double>(),
          .residuals = residuals.colwise().norm().transpose().cast<double>(),
          .vectors = vectors.cast<double>(),
          .expansion_error = static_cast<double>((vectors * amplitudes - start).norm())};
}

const std::vector<VariableCoefficientField::Modes>& VariableCoefficientField::modes() const {
  std::call_once(decomposed_, [this] {
    if (shape_.dimensions == 1) {
      modes_.push_back(modes_of(0));
      return;
    }
    for (int l = 1; l <= static_cast<int>(start_.amplitudes.size()); ++l) {
      if (start_.amplitudes[l - 1] != 0.0) modes_.push_back(modes_of(l));
    }
  });
  return modes_;
}

// A is symmetric, so |E(A) v_k - E(-rate_k) v_k| is at most |r_k| times the steepest slope of E over the
// eigenvalues. Values at points and norms are below the norm of the vector: one bound holds for all columns.
reference::ReferenceValue VariableCoefficientField::exact_columns_at(double t) const {
  const Eigen::Index n = points_.points;
  Vec field = Vec::Zero(shape_.size());
  double bound = 0.0;
  for (const Modes& some : modes()) {
    const double steepest = steepest_decay(order_, some.rates.minCoeff(), t);
    Vec left(n);
    double off = some.expansion_error;
    for (Eigen::Index k = 0; k < n; ++k) {
      const DecayFactor part = decay_factor(order_, some.rates[k], t);
      left[k] = some.amplitudes[k] * part.value;
      off += std::abs(some.amplitudes[k]) *
             (part.bound + 32.0 * rounding_unit * std::abs(part.value) + 2.0 * steepest * some.residuals[k]);
    }
    bound += std::abs(some.amplitude_of_y) * off;
    const Vec of_x = some.amplitude_of_y * (some.vectors * left);
    for (Eigen::Index j = 0; j < shape_.size() / n; ++j) {
      const double of_y = some.of_y > 0 ? points_.sine(some.of_y, static_cast<int>(j) + 1) : 1.0;
      field.segment(j * n, n) += of_y * of_x;
    }
  }
  const Vec columns = columns_at(outputs(), t, field);
  return {columns, Vec::Constant(columns.size(), bound)};
}

Medium::Medium(const Parameters& parameters)
    : kind_(parameters.choice("medium")), contrast_(parameters["contrast"]) {}

double Medium::at(double x) const {
  if (is_uniform()) return 1.0;
  if (kind_ == "halves") return x < 0.5 ? 1.0 : contrast_;
  const double between = std::sin(std::numbers::pi * x);
  return std::pow(contrast_, between * between);
}

std::vector<Parameter> medium_parameters() {
  return {choice("medium", {"even", "wave", "halves"},
                 "a(x) in kappa div(a grad u): 1, contrast^(sin^2 pi x), or 1 below x = 1/2 and contrast "
                 "from there"),
          {"contrast", 10.0, {.low = 1e-6, .high = 1e6}, "of the media that are not even"}};
}

}  // namespace fde::bench
