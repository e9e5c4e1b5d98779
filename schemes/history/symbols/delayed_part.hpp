// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/history/weights/polylogarithm.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// A lag in steps of this length; a whole number where the two agree to 1e-9.
double steps_in(double lag, double length);

// The matrix sum_k B_k L_k(zeta) of a linear f = A y + sum_k B_k y(t - lag_k) in a run with equal steps. With
// Y the generating function of the results, L_k Y is that of the values that the run looks up: L_k = zeta^m
// for a lag of m steps, otherwise the symbol of the polynomials through eight results (StoredResults) far
// from breaking points.
class DelayedPart {
 public:
  // Row i of f is evaluated at t_(n-1) + offsets[i] h, when the results up to t_(n-1) are known.
  // Precondition: no lag is shorter than a step.
  DelayedPart(const std::vector<double>& lags, const std::vector<Matrix>& factors, double length,
              const Vec& offsets);

  [[nodiscard]] bool is_empty() const { return rows_.empty(); }
  [[nodiscard]] ComplexMatrix at(ComplexValue log_zeta) const;

 private:
  // A row that is not 0 of one of the B_k, and the weights of the results of `newest`, newest + 1, ... steps
  // before t_n.
  struct Row {
    Eigen::Index index;
    Eigen::RowVectorXcd factors;
    double newest;
    Vec weights;
  };
  Eigen::Index size_;
  std::vector<Row> rows_{};
};

}  // namespace fde
