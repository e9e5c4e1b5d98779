// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <variant>
#include <vector>

#include "fdebench/schemes/problem/chain.hpp"

namespace fde {

// How the gradient by y of force(t, y) - factor(t, y) * sum is given, with sum = sum_k c_k D^(a_k) u held
// constant.
struct LinearForce {
  double by_u;  // the force is by_u * u + (a function of t), the factor 1
};
struct ForceGradient {
  // Adds this gradient to `gradient`, which has one entry per row of the problem.
  std::function<void(double t, In y, double sum, Out gradient)> add;
};

// A multi-term equation of a scene: its left side, its force and their derivatives. y is the state of the
// whole problem, so equations may be coupled.
struct MultiTermEquation {
  Chain chain;
  std::function<double(double t, In y)> force;
  std::function<double(double t, In y)> factor{};  // empty: 1
  std::variant<NoDerivatives, LinearForce, ForceGradient> derivatives{};
};

// The problem of these equations on 0 < t <= end: components, right-hand side, derivatives as far as all
// equations give them, and Problem::equations. Throws std::invalid_argument where the rows of the chains are
// not contiguous from row 0 on.
Problem chain_problem(const std::vector<MultiTermEquation>& equations, double end);

// The chain of one of problem.equations: its nodes, coefficients and initial values.
Chain chain_of(const Problem& problem, const Equation& equation);

}  // namespace fde
