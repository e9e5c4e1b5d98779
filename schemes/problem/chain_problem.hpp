#pragma once

#include <functional>
#include <variant>
#include <vector>

#include "problem/chain.hpp"

namespace fde {

// The derivatives by y of force(t, y) - factor(t, y) * sum, where sum = sum_k c_k D^(a_k) u is held.
struct LinearForce {
  double by_u;  // the force is by_u * u + (a function of t), the factor 1
};
struct ForceGradient {
  // gradient += those derivatives.
  std::function<void(double t, In y, double sum, Out gradient)> add;
};

// A multi-term equation as a scene declares it: the left side, and what drives it. y is that of the whole
// problem, so that equations may drive each other.
struct DrivenChain {
  Chain chain;
  std::function<double(double t, In y)> force;
  std::function<double(double t, In y)> factor{};  // empty: 1
  std::variant<NoDerivatives, LinearForce, ForceGradient> derivatives{};
};

// The problem of these equations, 0 < t <= end: components, right-hand side, what can be told of the
// derivatives, and Problem::equations. Throws std::invalid_argument where the chains do not stand one after
// the other, from row 0 on.
Problem chain_problem(const std::vector<DrivenChain>& equations, double end);

// The chain of one of problem.equations: its nodes, coefficients and initial values.
Chain chain_of(const Problem& problem, const Equation& equation);

}  // namespace fde
