// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "fdebench/reference/reference.hpp"
#include "fdebench/reference/special_functions/numbers/rational.hpp"

namespace fde::reference {

// The solution of a linear initial value problem as a function of those initial values that are unknown: its
// outputs, and what is given at the end.
struct SolutionByInitialValues {
  using Values = std::vector<Rational>;
  std::function<Reference(const Values&)> outputs, given_at_end;
};

// The outputs of the solution with these values at the end, as many as there are unknown initial values. By
// superposition y(t; s) = y(t; 0) + sum_k s_k u_k(t); the linear system for s at the end is solved with 30
// digits more than are asked for, and with s so rounded the outputs are those of an initial value problem.
// Their bounds contain |ds_k| |u_k(t)|, where |ds| is bounded by the residual of the system (Rump, Acta
// Numerica 19 (2010)). Both functions of the result throw std::runtime_error if the values at the
// end do not determine s with so many digits.
Reference with_values_at_end(SolutionByInitialValues solution, double end, std::vector<Rational> values);

}  // namespace fde::reference
