// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/stepping/run.hpp"

namespace fde {

// The product trapezoidal rule on a grid, also for problems with multipliers (problem/multipliers.hpp).
//
// The rule contains a multiplier only in means over neighbouring times of the grid. In q' = v, v' = a + R^T
// lambda, 0 = g(t, q, v) these are R_(n-1)^T lambda_(n-1) + R_n^T lambda_n: an error of lambda_(n-1) returns
// in lambda_n with the opposite sign, and never decays. There is an error from the start where lambda(0) is
// not known, and one of about h_1^-alpha where lambda ~ t^-alpha has no value there. Where R rotates, this
// error enters v: the error of v is about h^2 h_1^-alpha, which on graded grids need not be small.
//
// Therefore a multiplier is constant on each step: lambda_n on the step to t_n. On this step f is the linear
// function between
//   f(t_(n-1), y_(n-1), lambda_n)  and  f(t_n, y_n, lambda_n),
// with jumps between the steps, and it is integrated exactly. lambda(0) does not occur, and no lambda depends
// on the one before. At order 1 the step adds h (R_(n-1) + R_n)^T lambda_n / 2, as in symmetric projection
// (Hairer, BIT 40 (2000)).
//
// In the trajectory the multipliers at t_n are extrapolated from the middles of the last two steps; at the
// first step its constant is returned.
Trajectory solve_product_trapezoidal(const Problem& problem, const Grid& grid, const Options& options);

// Why the rule is not applicable, as half a sentence: a multiplier enters a row of order above 1; more than
// one order is integrated between a multiplier and its constraint (index above 2), so that the errors of the
// rows between alternate in the same way; or the problem is two-sided. nullopt: it is applicable, or there is
// no multiplier.
std::optional<std::string> unsupported_multipliers_reason(const Problem& problem);

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
