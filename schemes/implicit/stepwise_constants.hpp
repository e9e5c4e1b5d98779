#pragma once

#include <memory>
#include <vector>

#include "history/running_sum.hpp"
#include "stepping/run.hpp"

namespace fde {

// Functions p_i that are constant on each step of a grid, integrated exactly:
//   1/Gamma(g) int_0^t (t-s)^(g-1) p_i(s) ds,  g <= 1 the order of component i.
// That is the derivative of order 1 - g of the integral of p_i, which is linear on each step: a running sum
// at order 1, and below what L1 does. Algebraic rows have no part in it. Above order 1 p_i has to be 0: the
// integral of anything else is not a number.
class StepwiseConstants {
 public:
  StepwiseConstants(const Problem& problem, const Grid& grid, const Options& options);

  // Appends the values on the step of this length that ends at t. The first call is for t = 0, with zeros.
  void push(double t, double length, In values);

  // Adds the integrals up to t, one step of this length later, with p = 0 on that step.
  void add_integrals(double t, double length, Out sums);

  [[nodiscard]] std::size_t bytes() const { return fractional_ ? fractional_->bytes() : 0; }

 private:
  const Problem& problem_;
  RunningSums totals_;               // of the components of order 1
  std::vector<Eigen::Index> below_;  // the components of order below 1
  std::vector<WeightTable> tables_;  // of these
  std::unique_ptr<History> fractional_;
  Vec buffer_;
};

}  // namespace fde
