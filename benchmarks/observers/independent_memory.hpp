#pragma once

#include <vector>

#include "observers/fitted_powers.hpp"
#include "problem/grid.hpp"
#include "problem/problem.hpp"

namespace fde {

// D^order q from values of v = q' on a uniform grid, without any scheme: product integration of order 4
// (5 - order above order 1); of schemes with that rate or a higher one it shows its own error. With b =
// ceil(order) - order it is J^b v for order < 1 and J^b v' for 1 < order < 2. On each step v is the cubic
// through the four values around it (the last four at an end of the grid), which is integrated exactly
// against the kernel. Where v starts with powers t^p that no cubic follows, coefficients c_p are fitted to
// the first values (FittedPowers) and c_p (exact - cubic) is added: start weights in the manner of Lubich
// 1986, computed from the difference of the two and not as a difference of sums.
class IndependentMemory {
 public:
  // Fewer steps have no cubic at each end and no start.
  static constexpr int fewest_steps = 16;

  // Powers: those with which v leaves v(0), not 0. Throws std::invalid_argument for an order that is whole or
  // outside (0, 2), for a graded grid and for fewer steps.
  IndependentMemory(const Grid& grid, double order, const std::vector<double>& powers);

  // D^order q(t_n), 1 <= n <= steps, from the velocities at all steps from 0 on.
  [[nodiscard]] double at(int n, const Vec& velocities) const;

 private:
  // What is added where a start goes with t^power, in units of the step.
  struct Start {
    double power;
    Eigen::Index row;        // of its coefficient
    Eigen::Vector4d values;  // of the first step's cubic
    Matrix far;              // (k, j): t^power less its cubic at the k-th Gauss node of step j + 1
    Vec near;  // the same integrated against the kernel that is singular at the end of step j + 1
    Vec first_nodes{}, first_weights{};  // exact on the first step for t^power times polynomials
  };
  void make_rule();
  void make_starts();
  [[nodiscard]] Vec power_at_steps(double power, int count) const;
  [[nodiscard]] double start_error(const Start& start, int n) const;

  Grid grid_;
  double exponent_;     // b - 1, of the kernel
  bool of_derivative_;  // order above 1
  double scale_;        // h^b / Gamma(b), over h for the derivative
  FittedPowers fit_;
  Matrix kernel_;  // (k, lag - 1): kernel times Gauss weight at the k-th Gauss node of the step that far back
  Matrix weights_;  // (r, lag - 1): of the value r - 1 steps after the begin of that step
  Vec reversed_;    // weights of whole values, the lag 0 last
  double ahead_{};  // of the value after the last
  std::vector<Start> starts_{};
};

}  // namespace fde
