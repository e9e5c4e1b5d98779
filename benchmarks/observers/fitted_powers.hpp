// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/reference/nonlinear/quadrature/gauss.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde::bench {

// Fits the start of values on a uniform grid, value(0) + sum_p c_p t^p, to the first few of them by least
// squares, with twice as many values as powers so that errors of the values are not amplified. Time is in
// units of the step size.
class FittedExponents {
 public:
  static constexpr std::size_t most = 5;

  // Uses the smallest `most` of the distinct powers. Integer powers should be included, to separate them from
  // the others.
  explicit FittedExponents(std::vector<double> powers);

  [[nodiscard]] const std::vector<double>& powers() const { return powers_; }

  // c_p, one for each power, from the values at steps 0, 1, ...; at least 2 most + 1 values.
  [[nodiscard]] Vec coefficients(const Vec& values) const;

 private:
  std::vector<double> powers_;
  Matrix inverse_{};  // (power, step - 1)
};

// Minimises |A x - b|, one column of x for each column b. Precondition: A has full rank and at least as many
// rows as columns.
reference::LongMatrix least_squares(const reference::LongMatrix& a, const reference::LongMatrix& b);

}  // namespace fde::bench
