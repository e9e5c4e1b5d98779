// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/reference/linear/load.hpp"
#include "fdebench/reference/reference.hpp"

namespace fde::reference {

// One term coefficient * time_scale^order * D^order u of a linear equation; order 0 is u itself. The power is
// computed at the requested precision; a product in double would be wrong after 16 digits.
template <class Number>
struct LinearTermOf {
  Number coefficient;
  Number order;
  Number time_scale{1};
};
using LinearTerm = LinearTermOf<double>;  // doubles are taken as their shortest decimals

// sum_i c_i D^(order_i) u = sum_k load_k(t): Caputo derivatives from 0, orders in [0, 2],
// u^(k)(0) = initial[k]. Terms with coefficient 0 are ignored; ceil(highest order) initial values are needed.
template <class Number>
struct LinearEquationOf {
  std::vector<LinearTermOf<Number>> terms;
  std::vector<Number> initial;
  std::vector<LoadOf<Number>> loads{};
};
using LinearEquation = LinearEquationOf<double>;

// D^order u for each of `orders` (0: u itself), one component per order; see linear_solution.hpp for its
// accuracy. Throws std::invalid_argument for an equation not of this form, and for an order above
// ceil(highest order).
Reference linear_reference(const LinearEquation& equation, const std::vector<double>& orders);
Reference exact_linear_reference(const LinearEquationOf<Rational>& equation,
                                 const std::vector<Rational>& orders);

}  // namespace fde::reference
