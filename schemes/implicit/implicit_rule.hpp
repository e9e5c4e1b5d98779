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
  // Turns a copy of y into what is told of the step. Empty: y is told.
  std::function<void(In y, Out told)> told{};
  // What these functions keep from step to step. Empty: nothing.
  State state{};
};

// The rule of the schemes that integrate f: past_n = Taylor part + kappa * (weighted sum of f_j).
ImplicitRule integral_rule(const Problem& problem, const WeightFamily& family);

// Steps the rule along the grid, each step solved by Newton's method from the previous value.
Trajectory solve_implicit(const Problem& problem, const Grid& grid, const Options& options,
                          const ImplicitRule& rule);

}  // namespace fde
