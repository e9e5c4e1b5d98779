#pragma once

#include <Eigen/Core>
#include <vector>

namespace fde {

// How a solution starts at t = 0: y_i(t) = Taylor part + sum_p c_p t^p with c_p != 0. It decides the rate of
// every scheme. powers[i] lists those p in increasing order, at least up to order_i + 2; later ones change no
// rate here.
struct Smoothness {
  std::vector<std::vector<double>> powers{};
  std::vector<Eigen::Index> jumps{};  // components whose right-hand side jumps later, at a time of the grid
};

// The powers start + (sums of the steps), up to last, in increasing order: {start + k1 steps[0] + k2 steps[1]
// + ...}.
std::vector<double> power_lattice(const std::vector<double>& start, const std::vector<double>& steps,
                                  double last);

}  // namespace fde
