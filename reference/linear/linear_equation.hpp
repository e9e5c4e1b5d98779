#pragma once

#include <vector>

#include "linear/load.hpp"
#include "reference.hpp"

namespace fde {

// One term coefficient * time_scale^order * D^order u of a linear equation; order 0 is u itself. The power is
// taken at the precision asked for, where a product in double would be off after 16 digits.
struct LinearTerm {
  double coefficient;
  double order;
  double time_scale = 1.0;
};

// sum_i c_i D^(order_i) u = sum_k load_k(t): Caputo derivatives from 0, orders in [0, 2], u^(k)(0) =
// initial[k]. Terms with coefficient 0 do not count; ceil(highest order) initial values are needed.
struct LinearEquation {
  std::vector<LinearTerm> terms;
  std::vector<double> initial;
  std::vector<Load> loads{};
};

// D^order u for each of the orders (0: u itself), as a reference: components are those derivatives in
// turn; see linear_solution.hpp for what it is good to. Throws std::invalid_argument for an equation that is
// not posed like this.
Reference linear_reference(const LinearEquation& equation, const std::vector<double>& orders);

}  // namespace fde
