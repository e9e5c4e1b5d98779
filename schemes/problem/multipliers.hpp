// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// The unknowns of algebraic rows that occur in no algebraic row, only in rows with derivatives: the Lagrange
// multipliers, such as lambda in
//   q' = v,  v' = a + R^T lambda,  0 = g(t, q, v).
// An unknown occurs in a row if perturbing it changes any bit of the row at t = 0 or at a later time.
std::vector<Eigen::Index> multipliers(const Problem& problem);

// The total order of integration between a multiplier and its constraint, maximal over the multipliers: 1
// above where g depends on v (index 2), 2 where it depends on q only (index 3). If the integral of order g of
// a row over a short time h is replaced by h^g / Gamma(g+1), a unit residual of a constraint changes its
// multiplier by a number of size h^-p as h -> 0; the result is p. NaN where the constraints at t = 0 do not
// determine the multipliers.
double multiplier_integration_order(const Problem& problem);

// The first constraint that makes the initial values inconsistent: an algebraic row with a residual at
// t = 0, with no algebraic unknown in it that could remove the residual, and with a multiplier that is
// integrated by an order of at least 1. To satisfy it for t > 0 the multiplier would have to be an impulse,
// and the solution would not start at its initial values. With an integrated order p below 1 an integrable
// multiplier like t^-p is enough. nullopt: there is no such row.
std::optional<Eigen::Index> inconsistent_initial_row(const Problem& problem);

}  // namespace fde
