#pragma once

#include "truth.hpp"

namespace fde {

// Reference solution of a nonlinear multi-order system by piecewise collocation: independent of every scheme.
// On each panel of a mesh graded towards t = 0, f(t, y(t)) is a polynomial through Gauss points, and
//   y_i(t) = Taylor part + 1/Gamma(gamma_i) int_0^t (t-s)^(gamma_i-1) f_i(s) ds
// holds at them. The error estimate is the difference to a second solve with other panels and another degree,
// with an allowance for the rounding of f, which both share.
struct CollocationOptions {
  double tolerance = 1e-13;  // relative, asked of the panel resolution; rounding allows about 1e-14
};

// Orders are in (0, 2]; f is continuous, and smooth for t > 0. Truth::bound is an estimate.
// Throws std::runtime_error naming the time where Newton's method or the panel refinement does not converge,
// and std::invalid_argument for a problem it cannot pose or, from Exact::at, a time outside [0, problem.end].
Exact reference_solution(const Problem& problem, const CollocationOptions& options = {});

}  // namespace fde
