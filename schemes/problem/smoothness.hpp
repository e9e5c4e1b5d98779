// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <vector>

namespace fde {

// The expansion of a solution at t = 0, y_i(t) = Taylor part + sum_p c_p t^p with c_p != 0, which determines
// the rate of every scheme. powers[i] lists the p in increasing order, at least up to order_i + 2; larger
// ones change no rate. The powers of a right row are those of end - t. Algebraic rows have none: they hold
// exactly at every step. With multipliers the powers of a row are those of its right-hand side, projected off
// the constraint reaction, after integration: the constraint determines the rest.
struct Smoothness {
  std::vector<std::vector<double>> powers{};
  std::vector<Eigen::Index> jumps{};       // components whose right-hand side jumps at a grid time t > 0
  std::vector<Eigen::Index> unmeasured{};  // components that are not measured: their errors in the first
                                           // steps count only through the other components, after integration
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

}  // namespace fde
