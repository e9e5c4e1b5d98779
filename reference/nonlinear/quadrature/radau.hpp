// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace fde::reference {

// Small matrices in extended precision with storage on the stack.
constexpr int max_stages = 16;
using Stages = Eigen::Matrix<long double, Eigen::Dynamic, 1, 0, max_stages, 1>;
using StageMatrix =
    Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic, 0, max_stages + 1, max_stages + 1>;

// The Radau IIA method with s stages on the step [0, 1]: collocation at the zeros of
// P_s(2x-1) - P_(s-1)(2x-1), the last of which is 1. L-stable, with rate 2s-1 at the end of a step and s+1 at
// its stages. Hairer & Wanner, Solving Ordinary Differential Equations II, section IV.5.
struct RadauRule {
  explicit RadauRule(int stages);  // in [1, max_stages], else std::invalid_argument

  Stages nodes;
  // (i, j): the Runge-Kutta matrix, int_0^nodes[i] of the Lagrange polynomial of nodes[j].
  StageMatrix integral;
  Eigen::MatrixXd at_nodes;    // Legendre coefficients of a polynomial from its values at the nodes
  Eigen::MatrixXd with_start;  // the same from its values at 0 and at the nodes
};

}  // namespace fde::reference
