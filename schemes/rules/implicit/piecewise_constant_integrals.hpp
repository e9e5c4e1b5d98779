// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/stepping/run.hpp"

namespace fde {

// Functions p_i that are constant on each step of a grid, integrated exactly:
//   1/Gamma(g) int_0^t (t-s)^(g-1) p_i(s) ds,  g <= 1 the order of component i.
// This is the derivative of order 1 - g of the integral of p_i, which is linear on each step: a running sum
// at order 1, the L1 sum below. Above order 1, p_i must be 0; otherwise the integral is NaN.
class PiecewiseConstantIntegrals {
 public:
  // components: the indices i with p_i != 0.
  PiecewiseConstantIntegrals(const Problem& problem, const std::vector<Eigen::Index>& components,
                             const Grid& grid, const Options& options);

  // Appends the values on the step of this length that ends at t. values has problem.size() entries.
  // Precondition: the first call is for t = 0, with zeros.
  void push(double t, double length, In values);

  // Adds to sums the integrals up to t, the end of the next step, of this length, with p = 0 on that step.
  void add_integrals(double t, double length, Out sums);

  [[nodiscard]] std::size_t bytes() const { return fractional_ ? fractional_->bytes() : 0; }

  void state(Archive& archive) {
    archive(totals_);
    if (fractional_) archive(fractional_);
  }

 private:
  std::vector<Eigen::Index> whole_, above_, below_;  // the components of order 1, above 1, below 1
  RunningSums totals_;                               // of the first two
  std::vector<WeightTable> tables_;                  // of the last
  std::unique_ptr<History> fractional_;
  Vec buffer_;
};

}  // namespace fde
