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

}  // namespace fde::reference
