#pragma once

#include <functional>

#include "implicit/newton.hpp"
#include "stepping/run.hpp"

namespace fde {

// An implicit rule in the form all of them share: y_n = past_n + kappa f(t_n, y_n), kappa the step_factor of
// each component's table. Algebraic rows have no past: it is 0 = f_i(t_n, y_n) that is solved, and what the
// functions of the rule say about them is not looked at.
struct ImplicitRule {
  std::vector<WeightTable> tables;  // of the one sum over the past
  // past_n from that sum, y_{n-1} and kappa.
  std::function<void(double t, In convolved, In previous, In kappa, Out past)> past;
  // What joins the past after a step: f(t, y) or the increment of y.
  std::function<void(Run& run, double t, In y, In previous, Out sample)> sample;
};

// The rule of the schemes that integrate f: past_n = Taylor part + kappa * (weighted sum of f_j).
//
// The trapezoidal family weighs f_0, and so takes the initial values of algebraic rows at their word. In q' =
// v, v' = a + R^T lambda, 0 = g(t, q, v) it only sees (lambda_(n-1) + lambda_n) / 2, so that a wrong
// lambda(0), or one that is infinite, makes lambda alternate about its values, by the same amount for ever.
// For constant R nothing else notices; otherwise q and v are off by O(h^2), which does not change their rate.
ImplicitRule integral_rule(const Problem& problem, const WeightFamily& family);

// Steps the rule along the grid, each step solved by Newton's method from the previous value.
Trajectory solve_implicit(const Problem& problem, const Grid& grid, const Options& options,
                          const ImplicitRule& rule);

}  // namespace fde
