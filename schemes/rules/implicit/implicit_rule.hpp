// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/rules/implicit/newton.hpp"
#include "fdebench/schemes/stepping/rates.hpp"
#include "fdebench/schemes/stepping/run.hpp"

namespace fde {

// An implicit rule in the common form y_n = known_n + kappa f(t_n, y_n), with kappa the step_factor of each
// component's table. Algebraic rows have no memory term: they read 0 = f_i(t_n, y_n), and the values that the
// functions of the rule set for them are not used.
struct ImplicitRule {
  std::vector<WeightTable> tables;  // of the convolution over the history
  // Sets known_n, from that convolution, y_{n-1} and kappa.
  std::function<void(double t, In convolved, In previous, In kappa, Vec& known)> known;
  // The sample that a step, when it begins, adds to the history: that at t_(n-1) = t. Empty: f(t, y).
  std::function<void(double t, In y, In previous, Vec& sample)> sample{};
  // Changes a copy of y into the recorded result of the step. Empty: y is recorded.
  std::function<void(In y, Out recorded)> recorded_result{};
  // Saves or restores the state that these functions keep between steps. Empty: they keep none.
  StateArchiver state{};
};

// The rule of the schemes that integrate f: known_n = Taylor part + kappa * (weighted sum of f_j, j < n).
ImplicitRule integral_rule(const Problem& problem, const WeightFamily& family);

// Solves the problem with the rule on the grid; each step is solved by NewtonSolver. Never throws for
// numerical failure: see Trajectory::status.
Trajectory solve_implicit(const Problem& problem, const Grid& grid, const Options& options,
                          const ImplicitRule& rule);

// The theories of the rules that are a scheme of their own and, in integrated form, one for multi-term
// equations.

// The product trapezoidal rule: h^2, and the rates of linear interpolation of f.
extern const RateTheory trapezoidal_theory;

// Backward Euler convolution quadrature: h; a power p has the error h^p at the first step.
extern const RateTheory grunwald_letnikov_theory;

}  // namespace fde
