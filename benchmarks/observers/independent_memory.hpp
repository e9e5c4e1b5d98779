// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/benchmarks/observers/fitted_powers.hpp"
#include "fdebench/schemes/problem/grid.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde::bench {

// D^order q from the values of v = q' on a uniform grid, independent of any scheme: product integration of
// order 4 (5 - order above order 1). For a scheme with at least that rate, the result shows the error of this
// rule instead. With b = ceil(order) - order it is J^b v for order < 1 and J^b v' for 1 < order < 2. On each
// step v is the cubic through the four values around it (the last four at an end of the grid), integrated
// exactly against the kernel. If v starts with powers t^p that are not cubic, coefficients c_p are fitted to
// the first values (FittedExponents) and c_p (exact - cubic) is added: starting weights as in Lubich 1986,
// computed from the difference itself, not as a difference of sums.
class IndependentMemoryRule {
 public:
  // The minimum for cubics at both ends and the start correction.
  static constexpr int fewest_steps = 16;

  // `powers`: the exponents, without 0, with which v - v(0) starts. Throws std::invalid_argument for an
  // integer order or one outside (0, 2), for a graded grid and for too few steps.
  IndependentMemoryRule(const Grid& grid, double order, const std::vector<double>& powers);

  // D^order q(t_n), 1 <= n <= steps, from the velocities at steps 0, 1, ...
  [[nodiscard]] double at(int n, const Vec& velocities) const;

 private:
  // The correction for a term t^power, in units of the step size.
  struct PowerCorrection {
    double power;
    Eigen::Index row;        // row of its coefficient
    Eigen::Vector4d values;  // at the nodes of the cubic of the first step
    Matrix far;              // (k, j): t^power minus its cubic at the k-th Gauss node of step j + 1
    Vec near;  // the same integrated against the kernel with its singularity at the end of step j + 1
    Vec first_nodes{}, first_weights{};  // exact on the first step for t^power times polynomials
  };
  void make_rule();
  void make_starts();
  [[nodiscard]] Vec power_at_steps(double power, int count) const;
  [[nodiscard]] double start_error(const PowerCorrection& start, int n) const;

  Grid grid_;
  double exponent_;     // b - 1, exponent of the kernel
  bool of_derivative_;  // order above 1
  double scale_;        // h^b / Gamma(b), over h for the derivative
  FittedExponents fit_;
  // (k, lag - 1): kernel times Gauss weight at the k-th Gauss node of the step `lag` steps back.
  Matrix kernel_;
  Matrix weights_;        // (r, lag - 1): weight of the value r - 1 steps after the start of that step
  Vec reversed_;          // total weight of each value, lag 0 last
  double next_weight_{};  // weight of the value after the last
  std::vector<PowerCorrection> starts_{};
};

}  // namespace fde::bench
