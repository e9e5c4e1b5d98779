// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// A breaking point of the right-hand side f of a row at a time t_m > 0: f is smooth but for a term (t -
// t_m)^power for t > t_m. It jumps where the power is 0, and has a kink where it is 1.
struct BreakingPoint {
  Eigen::Index row;
  double power;
};

// The expansion of a solution at t = 0, y_i(t) = Taylor part + sum_p c_p t^p with c_p != 0, which determines
// the rate of every scheme. powers[i] lists the p in increasing order, at least up to order_i + 2; larger
// ones change no rate. The powers of a right row are those of end - t. Algebraic rows have none: they hold
// exactly at every step. With multipliers the powers of a row are those of its right-hand side, projected off
// the constraint reaction, after integration: the constraint determines the rest.
struct Smoothness {
  std::vector<std::vector<double>> powers{};
  std::vector<BreakingPoint> breaking_points{};  // of each row the one of the smallest power
  // Components that are not measured: their errors in the first steps count only through the other
  // components, after integration.
  std::vector<Eigen::Index> unmeasured{};
};

// Orders and powers closer than this are equal: sums of increments such as 0.1 have rounding errors.
inline bool same_order(double a, double b) { return std::abs(a - b) < 1e-9; }
inline bool is_integer_order(double order) { return same_order(order, std::round(order)); }

// Powers closer than this count as one in the closures below: near an integer order they are dense.
inline constexpr double power_separation = 1e-5;

// The smallest set of powers up to `last` that contains `start` and, with each p, all of next(p). In
// increasing order; powers closer than power_separation count as one. Precondition: next(p) are larger than
// p.
std::vector<double> power_closure(std::vector<double> start, double last,
                                  const std::function<std::vector<double>(double p)>& next);

// The powers start + (sums of the steps), up to last: {start + k1 steps[0] + k2 steps[1] + ...}.
std::vector<double> power_lattice(const std::vector<double>& start, const std::vector<double>& steps,
                                  double last);

// The term coefficients[i] t^power of f_i, one coefficient a component.
struct PowerLoad {
  double power;
  Vec coefficients;
};

// The powers of t in the series at t = 0 of the solution of D^(order_i) y_i = sum_j matrix(i, j) y_j + loads;
// a term t^p of f_i gives t^(p + order_i) in y_i. Coefficients that cancel to rounding count as 0. Of several
// powers of a component within power_separation only the first is kept. Throws std::invalid_argument naming
// the component for an algebraic row, whose powers follow from the others, and for a right derivative, whose
// series is at the other end.
Smoothness linear_smoothness(const std::vector<Component>& components, const Matrix& matrix,
                             const std::vector<PowerLoad>& loads = {});

}  // namespace fde
