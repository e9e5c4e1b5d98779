#pragma once

#include <optional>
#include <vector>

#include "problem/problem.hpp"

namespace fde {

// The unknowns of algebraic rows that no algebraic row holds. They enter other rows only, and the algebraic
// rows constrain what these integrate: the lambda of
//   q' = v,  v' = a + R^T lambda,  0 = g(t, q, v).
// Found by moving each of them, at t = 0 and at a later time: a row that does not change there, by any bit,
// does not hold it.
std::vector<Eigen::Index> multipliers(const Problem& problem);

// How many orders the rows between a multiplier and its constraint integrate, the most of all multipliers:
// that of v above, 1, where g holds v (index 2), and 2 where it only holds q (index 3). With h^order /
// Gamma(order+1) for the integral of a row over a short time h, a multiplier answers a constraint that is off
// by 1 with a number of the size h^-p as h tends to 0; p is the result. NaN where the constraints at t = 0 do
// not determine the multipliers.
double integrated_orders(const Problem& problem);

// The first algebraic row that the initial values do not satisfy, that holds no unknown of such rows which
// could mend that, and whose multiplier is integrated once or more: to be met from t = 0 on it would need a
// multiplier without an integral, and the run would begin elsewhere than at its initial values. Where less
// than one order is integrated a multiplier like t^-order does, as that of a constraint above order 1.
std::optional<Eigen::Index> row_off_at_start(const Problem& problem);

}  // namespace fde
