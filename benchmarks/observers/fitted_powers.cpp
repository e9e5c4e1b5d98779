// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/observers/fitted_powers.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde::bench {

FittedExponents::FittedExponents(std::vector<double> powers) : powers_(std::move(powers)) {
  powers_ = increasing(std::move(powers_), same_order);
  if (powers_.size() > most) powers_.resize(most);
  const auto count = static_cast<Eigen::Index>(powers_.size());
  if (count == 0) return;
  reference::LongMatrix values(2 * count, count);  // columns scaled to largest entry 1
  reference::LongVec largest(count);
  for (Eigen::Index p = 0; p < count; ++p) {
    const auto power = static_cast<long double>(powers_[static_cast<std::size_t>(p)]);
    largest[p] = std::pow(static_cast<long double>(2 * count), power);
    for (Eigen::Index l = 0; l < 2 * count; ++l)
      values(l, p) = std::pow(static_cast<long double>(l + 1), power) / largest[p];
  }
  const reference::LongMatrix inverse =
      least_squares(values, reference::LongMatrix::Identity(2 * count, 2 * count));
  inverse_ = (inverse.array().colwise() / largest.array()).cast<double>();
}

Vec FittedExponents::coefficients(const Vec& values) const {
  return inverse_ * (values.segment(1, inverse_.cols()).array() - values[0]).matrix();
}

reference::LongMatrix least_squares(const reference::LongMatrix& a, const reference::LongMatrix& b) {
  const Eigen::ColPivHouseholderQR<reference::LongMatrix> orthogonal(a);
  reference::LongMatrix x(a.cols(), b.cols());
  for (Eigen::Index j = 0; j < b.cols(); ++j) x.col(j) = orthogonal.solve(reference::LongVec(b.col(j)));
  return x;
}

}  // namespace fde::bench
