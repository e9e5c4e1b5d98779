// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/error_tolerance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace fde {

namespace {

// Bound for the rounding errors in each row, from the largest |y| of the row and the size of its terms.
Eigen::ArrayXd noise(const Eigen::ArrayXd& largest, In terms) {
  constexpr double above_rounding = 50.0 * std::numeric_limits<double>::epsilon();
  // Smaller errors would involve subnormal numbers, in which Newton's method loses relative accuracy.
  constexpr double smallest = std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();
  return (above_rounding * largest.max(terms.array())).max(smallest);
}

// +1 or -1, the same in every run. The signs of two rows differ in half of the trials.
double sign(Eigen::Index row, int trial) {
  constexpr std::uint64_t odd = 0x9e3779b97f4a7c15, other = 0xbf58476d1ce4e5b9;
  std::uint64_t bits = (static_cast<std::uint64_t>(row) * 16 + static_cast<std::uint64_t>(trial)) * odd;
  bits = (bits ^ (bits >> 30U)) * other;
  return (bits >> 32U) % 2 == 0 ? 1.0 : -1.0;
}

}  // namespace

Vec ErrorTolerance::on_step(In least, In largest, In terms, In unresolved) const {
  constexpr double of_row = 0.01;
  // The absolute tolerance decides above this share of the relative one; largest growth of a row that counts.
  constexpr double counts = 1e-3, growth = 16.0;
  const bool by_least = accuracy_.atol > counts * accuracy_.rtol;
  const Eigen::ArrayXd size = by_least ? least.array() : largest.array();
  const Eigen::ArrayXd allowed = accuracy_.atol + accuracy_.rtol * size;
  Eigen::ArrayXd rounded = largest.array();
  if (by_least) rounded = rounded.min(growth / accuracy_.rtol * allowed);
  const Eigen::ArrayXd rounding = noise(rounded, terms);
  if (largest_.size() == 0) return allowed.max(rounding);
  const auto starts_from_rest = largest_.array() <= (after_jump_ ? of_row : 0.0) * largest.array();
  const auto by_size = of_row * largest.array().max(largest_.array());
  return starts_from_rest.select(allowed, allowed.min(by_size.max(unresolved.array()))).max(rounding);
}

Vec ErrorTolerance::from_tolerance(In largest, In terms) const {
  return (accuracy_.atol + accuracy_.rtol * largest.array()).max(noise(largest.array(), terms));
}

double ErrorTolerance::error_of_outputs(const Problem& problem, double t, In y, In errors, In terms) const {
  if (!problem.outputs) return 0.0;
  const Eigen::ArrayXd rounding = noise(y.array().abs(), terms);
  const Vec counted = (errors.array().abs() > rounding).select(errors, 0.0);
  const Vec outputs = problem.outputs(t, y), moved = problem.outputs(t, y + counted);
  const Eigen::ArrayXd allowed = accuracy_.atol + accuracy_.rtol * outputs.array().abs();
  return ((moved - outputs).array().abs() / allowed).maxCoeff();
}

void ErrorTolerance::accept_step(In largest) {
  if (largest_.size() == 0) largest_ = largest;
  largest_ = largest_.cwiseMax(largest);
  after_jump_ = false;
}

void RhsError::measure(const std::function<const Vec&(In y)>& f, In y, In permitted) {
  constexpr int trials_of_rounding = 8, most_bits = 6;
  constexpr double unit = std::numeric_limits<double>::epsilon(), above_largest = 10.0;
  const Vec unmoved = f(y);
  Vec moved = y;
  const auto add = [&](Vec& largest, double factor) {
    const Vec change = factor * (f(moved) - unmoved).cwiseAbs();
    largest = largest.cwiseMax(change.unaryExpr([](double v) { return std::isfinite(v) ? v : 0.0; }));
  };
  rounding_ /= 2.0;
  inherited_ /= 2.0;
  for (int trial = 0; trial < trials_of_rounding; ++trial) {
    const int size = 1 + trial / 2;
    const double part = size * unit;
    for (Eigen::Index i = 0; i < y.size(); ++i) moved[i] = y[i] * (1.0 + sign(i, trial) * part);
    add(rounding_, above_largest);
  }
  // For each two rows one of these sets of rows contains the first and not the second.
  for (int bit = 0; bit < most_bits && (Eigen::Index{1} << bit) < y.size(); ++bit) {
    for (const Eigen::Index side : {0, 1}) {
      const auto is_moved = [&](Eigen::Index i) { return ((i >> bit) & 1) == side; };
      for (Eigen::Index i = 0; i < y.size(); ++i)
        moved[i] = is_moved(i) ? y[i] + sign(i, bit) * permitted[i] : y[i];
      Vec change = Vec::Zero(y.size());
      add(change, 1.0);
      for (Eigen::Index i = 0; i < y.size(); ++i)
        if (!is_moved(i)) inherited_[i] = std::max(inherited_[i], change[i]);
    }
  }
  is_measured_ = true;
}

}  // namespace fde
