// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::bench {

// r(z), one value a measurement; nullopt where the model has no values.
using Residuals = std::function<std::optional<Vec>(const Vec& z)>;

struct LeastSquaresOptions {
  double tolerance = 1e-8;   // the relative change of z, and the square root of that of |r|^2, at convergence
  double difference = 2e-3;  // of each z, for dr/dz
  // The largest change in a step of variable j at this value; longer trials are rejected.
  std::function<double(Eigen::Index j, double z)> reach{};
};

// A minimum of |r(z)|^2.
struct LeastSquares {
  Vec z{}, residuals{};
  Matrix jacobian{};  // dr/dz there
  int iterations = 0;
  bool has_converged = false;
};

// Minimises |r(z)|^2 from `start` by the method of Levenberg and Marquardt in the form of Moré (1978), whose
// steps stay in a trust region: that of MINPACK's lmder, as Eigen has it. dr/dz is a central difference, a
// one-sided one where the model has no values on one side. A trial z without residuals is rejected as one
// with large ones. Precondition: no fewer residuals than z. Throws std::runtime_error where the model has no
// values at the start, or on both sides in a difference.
LeastSquares least_squares(const Residuals& residuals, Vec start, const LeastSquaresOptions& options);

}  // namespace fde::bench
