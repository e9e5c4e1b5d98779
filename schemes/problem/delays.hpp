// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// Adds the jumps of f one lag after 0, where y jumps at 0: where `before` of a problem with delays does not
// end at the initial values.
void add_jumps_of_start(Problem& problem);

// f(t, y) = a y + sum_k factors[k] y(t - lags[k]), where y is `before` for t < 0.
Delays linear_delays(std::vector<double> lags, const Matrix& a, const std::vector<Matrix>& factors,
                     const Vec& before);

// The derivatives of f by each y(t - lags[k]), by the differences of jacobian_at; `past` gives y before t.
// Exact where f is linear in these values and they are 0.
std::vector<Matrix> delayed_jacobians_at(const Problem& problem, double t, In y, const Past& past);

// A problem with delays as one without, for one run: its f looks up earlier values in the solution of the run
// itself (the method of steps: Bellen & Zennaro, Numerical Methods for Delay Differential Equations, 2003).
// So that these have been computed, no step is longer than the shortest lag; its breaking points are those of
// the delays too: f has a kink a sum of lags after 0 and after each breaking point. A problem without delays
// is itself.
class BoundProblem {
 public:
  // `problem` must outlive this object.
  explicit BoundProblem(const Problem& problem);
  BoundProblem& operator=(BoundProblem&&) = delete;

  // Valid as long as this object is.
  [[nodiscard]] const Problem& problem() const { return bound_; }

  // Gives y from 0 to the end of the last step, wherever a run has come. Before it is called the solution is
  // y(0) at all times.
  void set_solution(Past solution) { solution_ = std::move(solution); }

 private:
  void at(double t, Out y) const;
  void bind();

  const Delays& delays_;
  Problem bound_;
  Past solution_{};
};

}  // namespace fde
