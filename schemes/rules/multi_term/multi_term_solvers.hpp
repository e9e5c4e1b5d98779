// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

// Solves the integrated equations of a problem (integrated_equations.hpp) with the weights of one family,
// each step by Newton's method. A multistep rule has starting weights, and its first steps are one system
// (starting_procedure.hpp).
Trajectory solve_integrated_equations(const Problem& problem, const Grid& grid, const Options& options,
                                      const WeightFamily& family);

// Predictor-corrector method with the trapezoidal weights. Only g is predicted, by the line through its last
// two values; the terms of the equation are linear in the unknown and are solved exactly:
//   y^P = known + kappa (f_(n-1) + h_n/h_(n-1) (f_(n-1) - f_(n-2))),   y_n = known + kappa f(t_n, y^P).
// options.corrections: how often the second equation is applied.
Trajectory predict_and_correct_equations(const Problem& problem, const Grid& grid, const Options& options);

}  // namespace fde
