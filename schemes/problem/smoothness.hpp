#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <vector>

namespace fde {

// How a solution starts at t = 0: y_i(t) = Taylor part + sum_p c_p t^p with c_p != 0. It decides the rate of
// every scheme. powers[i] lists those p in increasing order, at least up to order_i + 2; later ones change no
// rate here. A right row starts at the end: its powers are those of end - t. Algebraic rows have none: what
// they state is exact at every step. In a problem with multipliers the powers of a row are those of what it
// integrates, projected off the reaction: the constraint determines the rest.
struct Smoothness {
  std::vector<std::vector<double>> powers{};
  std::vector<Eigen::Index> jumps{};   // components whose right-hand side jumps later, at a time of the grid
  std::vector<Eigen::Index> hidden{};  // components that nobody looks at: what they cost in the first steps
                                       // shows in the others only, after these have integrated it
};

// Orders and powers closer than this are the same: sums of increments such as 0.1 do not meet exactly.
inline bool same_order(double a, double b) { return std::abs(a - b) < 1e-9; }
inline bool whole(double order) { return same_order(order, std::round(order)); }

// Powers closer than this count as one where they lead to others: next to a whole order they are dense.
inline constexpr double distinct_powers = 1e-5;

// All powers up to last that start with the given ones and lead to others: next(p) are those that p leads to.
// In increasing order, each once: those closer than distinct_powers count as one.
std::vector<double> power_closure(std::vector<double> start, double last,
                                  const std::function<std::vector<double>(double p)>& next);

// The powers start + (sums of the steps), up to last: {start + k1 steps[0] + k2 steps[1] + ...}.
std::vector<double> power_lattice(const std::vector<double>& start, const std::vector<double>& steps,
                                  double last);

}  // namespace fde
