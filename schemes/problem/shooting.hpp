// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <optional>

#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/problem/resolution.hpp"

namespace fde {

// y(end) of an initial value problem by some method; nullopt: its run does not reach the end.
using EndOfRun = std::function<std::optional<Vec>(const Problem& problem)>;

// The unknown initial values s of a problem, and what Newton's method knows of F(s) = conditions(y(0; s),
// y(end; s)).
struct MissingValues {
  Vec values{};
  Matrix derivative{};                                      // dF/ds; empty: not known yet
  double missed = std::numeric_limits<double>::infinity();  // |F|, infinite if no run has reached the end
  bool converged = false;
};

// Shooting: Newton's method for the unknown initial values (Keller, Numerical Methods for Two-Point
// Boundary-Value Problems, 1968; of fractional equations Ford & Morgado, Fract. Calc. Appl. Anal. 14 (2011)).
// dF/ds comes from differences, one run a column, then from Broyden's updates; a step that does not bring the
// values nearer, or whose run does not reach the end, is halved (Deuflhard, Numer. Math. 22 (1974)). Of a
// linear problem with linear conditions F is affine, and one step is exact.
//
// Starts from `start`, by default from 0. `noise` bounds the error of y(end) that is no smooth function of s:
// of rounding, or of a tolerance. The method stops where F no longer falls, or where F and the next step are
// rounding; it has converged if both are within the noise, or at most sqrt(eps) relative to y. Preconditions:
// no right rows, as many conditions as unknown initial values.
MissingValues find_missing_values(const Problem& problem, const EndOfRun& run, const Tolerance& noise,
                                  MissingValues start = {});

// Whether the missing values are known: false where another method, or another resolution, changes them by
// more than a quarter of the solution, because the conditions hardly depend on them, or its run does not
// reach the end. So a problem without a solution, whose discretisation has one, is recognised. Precondition:
// `found` has converged.
bool are_determined(const Problem& problem, const MissingValues& found, const EndOfRun& other);

}  // namespace fde
