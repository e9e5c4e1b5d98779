// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/reference/linear/linear_equation.hpp"
#include "fdebench/reference/reference.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde::reference {

// D^(orders[i]) x_i = sum_j matrix(i, j) x_j + sum_k loads[i][k](t): Caputo derivatives from 0,
// x_i^(k)(0) = initial[i][k] for k < ceil(orders[i]); loads may be empty. Up to 12 components.
//
// Order 0 is an algebraic row, D^0 x_i = x_i, without initial values: matrix(i, i) = 1 gives the constraint
// 0 = sum of the other terms, which determines x_i as a multiplier in other rows. For initial values that are
// inconsistent with the constraints, the solution is the one after the jump at 0.
struct LinearSystem {  // of doubles, which are taken as their shortest decimals
  std::vector<double> orders;
  std::vector<std::vector<double>> initial;
  Matrix matrix;
  std::vector<std::vector<Load>> loads{};
  std::vector<std::size_t> outputs{};  // the requested components, in this order; empty: all
};

// The same in fractions.
struct ExactLinearSystem {
  std::vector<Rational> orders{};
  std::vector<std::vector<Rational>> initial{};
  std::vector<std::vector<Rational>> matrix{};  // by rows
  std::vector<std::vector<LoadOf<Rational>>> loads{};
  std::vector<std::size_t> outputs{};
};

// The requested components; see linear_solution.hpp for their accuracy. A multiplier may be infinite
// at t = 0, where velocities start like t^(1-order). Throws std::invalid_argument for a system not of this
// form, and where the algebraic rows do not determine every unknown.
Reference linear_reference(const LinearSystem& system);
Reference exact_linear_reference(const ExactLinearSystem& system);

}  // namespace fde::reference
