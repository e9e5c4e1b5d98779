// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// The derivative of distributed order, D u = int_from^to weight(q) D^q u dq, with Caputo derivatives
// (Caputo, Fract. Calc. Appl. Anal. 4, 2001), 0 <= from < to.
struct DistributedOrder {
  std::function<double(double q)> weight;
  double from, to;
};

// sum_k c_k D^(q_k) u, by increasing order and without terms of coefficient 0; the q_k are the nodes of the
// Gauss-Legendre rule, `nodes` of them between two whole orders, as the initial values that D^q contains
// change there (Diethelm & Ford, J. Comput. Appl. Math. 225, 2009, with the trapezoidal rule). D^q has the
// Laplace symbol s^q, which is entire in q: where the weight is smooth, the error falls geometrically with
// the number of nodes.
std::vector<Term> terms_of(const DistributedOrder& distributed, int nodes);

// The smallest number of nodes for which the symbol of the terms differs from that of D by at most this share
// of int |weight(q) s^q| dq, for |s| = 1/end ... 1e4/end: a solution of (0, end] changes by about as much,
// and by more only before 1e-4 end. Throws std::invalid_argument where 40 nodes are too few, because the
// weight is not smooth or end is above 1e100, and where it is not finite or 0 at all of them.
int nodes_for(const DistributedOrder& distributed, double end, double tolerance);

}  // namespace fde
