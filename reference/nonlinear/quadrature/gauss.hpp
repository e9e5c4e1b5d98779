// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace fde::reference {

// Weights that every panel uses are computed once in extended precision and then rounded to double.
using LongVec = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

// int_0^1 (1-x)^power p(x) dx = sum_k weights[k] p(nodes[k]) for polynomials p of degree < 2 count; nodes
// increase.
struct GaussRule {
  LongVec nodes, weights;
};
GaussRule gauss_jacobi(int count, long double power);  // power > -1; 0 is Gauss-Legendre

// The same with power 0, nodes.back() = 1 and polynomials of degree < 2 count - 1.
GaussRule gauss_radau(int count);

// (i, j): the Lagrange polynomial of nodes[j], which is 1 there and 0 at the other nodes, at points[i].
LongMatrix lagrange_matrix(const LongVec& nodes, const LongVec& points);

// (k, j): weight of p(nodes[j]) in the coefficient of the Legendre polynomial P_k(2x-1) of p, deg p < count.
// Precondition: the rule is Gauss-Legendre or Gauss-Radau.
LongMatrix legendre_analysis(const GaussRule& rule);

// The weights prod_{k != j} 1 / (nodes[j] - nodes[k]) of the barycentric interpolation formula.
LongVec barycentric_weights(const LongVec& nodes);

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
