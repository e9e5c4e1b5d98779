// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace fde {

// The largest power of 2 that is no larger than max |b_i|; 1 where that is 0 or not finite. An iteration with
// squares of vectors solves M x = b for b divided by it: for b of 1e-170 the squares would be 0. Powers of 2
// leave the digits of x as they are.
template <class Vector>
double unit_of(const Eigen::MatrixBase<Vector>& b) {
  const double largest = b.template lpNorm<Eigen::Infinity>();
  return largest > 0.0 && std::isfinite(largest) ? std::exp2(std::ilogb(largest)) : 1.0;
}

}  // namespace fde
