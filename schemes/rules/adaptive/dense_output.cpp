// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/adaptive/dense_output.hpp"

#include <algorithm>

#include "fdebench/schemes/history/weights/kernel_moments.hpp"

namespace fde {
namespace {

// From coefficients of 1, w, w^2 to those of the Legendre polynomials in 2w - 1, one row a polynomial.
DerivativePolynomials legendre(const DerivativePolynomials& powers) {
  DerivativePolynomials result(powers.rows(), powers.cols());
  result.col(0) = powers.col(0) + powers.col(1) / 2.0 + powers.col(2) / 3.0;
  result.col(1) = (powers.col(1) + powers.col(2)) / 2.0;
  result.col(2) = powers.col(2) / 6.0;
  return result;
}

}  // namespace

DenseOutput::DenseOutput(const Problem& problem) : taylor_(problem), size_(problem.size()) {
  for (Eigen::Index i = 0; i < size_; ++i) {
    const double order = problem.component(i).order;
    auto found = std::ranges::find(groups_, order, &OrderGroup::order);
    if (found == groups_.end()) found = groups_.insert(found, {order, {}});
    found->rows.push_back(i);
  }
}

void DenseOutput::add(double t, const DerivativePolynomials& derivatives,
                      const InterpolatedRows& interpolated, const Matrix& slopes) {
  if (slopes.size() > 0) {
    sloped_steps_.push_back(times_.size() - 1);
    slopes_.push_back(slopes);
  }
  times_.push_back(t);
  interpolated_.insert(interpolated_.end(), interpolated.begin(), interpolated.end());
  interpolated_offsets_.push_back(interpolated_.size());
  const DerivativePolynomials coefficients = legendre(derivatives);
  derivatives_.insert(derivatives_.end(), coefficients.data(), coefficients.data() + coefficients.size());
}

Eigen::Map<const DerivativePolynomials> DenseOutput::derivatives_on(std::size_t step) const {
  const auto size = static_cast<std::size_t>(3 * size_);
  return {derivatives_.data() + step * size, size_, 3};
}

Vec DenseOutput::at(double t) const {
  Vec y(size_);
  taylor_.at(t, y);
  const auto end = std::min(std::ranges::lower_bound(times_.begin() + 1, times_.end(), t), times_.end() - 1);
  const auto steps = std::max<Eigen::Index>(end - times_.begin(), 0);
  if (steps == 0) return y;
  const Eigen::Index last = steps - 1;
  Vec halves(steps), beyond(last);
  for (Eigen::Index k = 0; k < steps; ++k) {
    const auto step = static_cast<std::size_t>(k);
    halves[k] = (times_[step + 1] - times_[step]) / 2.0;
    if (k < last) beyond[k] = (t - times_[step + 1]) / halves[k];
  }
  const double since = (t - times_[static_cast<std::size_t>(last)]) / halves[last];
  for (const auto& [order, rows] : groups_) {
    if (order == 0.0) {
      const double x = since - 1.0;
      const Eigen::Vector3d polynomials(1.0, x, 1.5 * x * x - 0.5);
      for (const auto i : rows) y[i] = derivatives_on(static_cast<std::size_t>(last)).row(i) * polynomials;
      continue;
    }
    Matrix moments(steps, 3);
    moments << kernel_moments(order, beyond, 3), moments_inside_panel(order, since, 3).transpose();
    moments.array().colwise() *= halves.array().pow(order);
    for (Eigen::Index k = 0; k < steps; ++k) {
      const auto derivatives = derivatives_on(static_cast<std::size_t>(k));
      for (const auto i : rows) y[i] += derivatives.row(i).dot(moments.row(k));
    }
  }
  const auto newest = static_cast<std::size_t>(last);
  for (auto k = interpolated_offsets_[newest]; k < interpolated_offsets_[newest + 1]; ++k)
    y[interpolated_[k].row] = interpolated_[k].at(since / 2.0);
  const auto sloped = std::ranges::lower_bound(sloped_steps_, newest);
  if (sloped != sloped_steps_.end() && *sloped == newest)
    y += slopes_[static_cast<std::size_t>(sloped - sloped_steps_.begin())] * y;
  return y;
}

void DenseOutput::state(Archive& archive) {
  archive.resizable(times_);
  archive.resizable(interpolated_);
  archive.resizable(interpolated_offsets_);
  archive.resizable(sloped_steps_);
  slopes_.resize(sloped_steps_.size());
  for (auto& slopes : slopes_) archive.resizable(slopes);
  archive.resizable(derivatives_);
}

}  // namespace fde
