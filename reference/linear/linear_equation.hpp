// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "fdebench/reference/reference.hpp"
#include "fdebench/reference/special_functions/numbers/rational.hpp"

namespace fde::reference {

// The load coefficient * (t - start_time)^power for t >= start_time, power > -1; with over_gamma divided by
// Gamma(power + 1). Power 0 is a constant; a second load with the opposite sign switches it off.
template <class Number>
struct LoadOf {
  Number coefficient;
  Number power{0};
  Number start_time{0};
  bool over_gamma = false;
};
using Load = LoadOf<double>;  // doubles are taken as their shortest decimals

inline LoadOf<Rational> exact(const Load& load) {
  return {shortest_decimal(load.coefficient), shortest_decimal(load.power), shortest_decimal(load.start_time),
          load.over_gamma};
}

// The error message for an invalid load; nullopt for a valid one.
inline std::optional<const char*> validation_error(const Load& load) {
  if (!std::isfinite(load.coefficient)) return "loads have to be finite";
  if (!(load.power > -1.0 && std::isfinite(load.power))) return "powers of loads have to be above -1";
  if (!(load.start_time >= 0.0 && std::isfinite(load.start_time)))
    return "loads have to start at a time from 0 on";
  return std::nullopt;
}

// One term coefficient * time_scale^order * D^order u of a linear equation; order 0 is u itself. The power is
// computed at the requested precision; a product in double would be wrong after 16 digits.
template <class Number>
struct LinearTermOf {
  Number coefficient;
  Number order;
  Number time_scale{1};
};

// sum_i c_i D^(order_i) u = sum_k load_k(t): Caputo derivatives from 0, orders in [0, 10],
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
