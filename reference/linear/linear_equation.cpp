// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/linear_equation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "fdebench/reference/linear/linear_solution.hpp"

namespace fde::reference {
namespace {

constexpr const char* name = "linear equation";

void require(bool holds, const char* message) {
  if (!holds) throw std::invalid_argument(fmt::format("{}: {}", name, message));
}

// The equation without its zero terms, whose orders would otherwise count. Throws std::invalid_argument.
LinearEquation checked(LinearEquation equation, const std::vector<double>& orders) {
  double top = -1.0;
  for (const auto& [coefficient, order, time_scale] : equation.terms) {
    require(std::isfinite(coefficient), "coefficients have to be finite");
    require(order >= 0.0 && order <= 2.0, "orders have to be in [0, 2]");
    require(time_scale > 0.0 && std::isfinite(time_scale), "time scales have to be positive");
    if (coefficient != 0.0) top = std::max(top, order);
  }
  std::erase_if(equation.terms, [](const LinearTerm& term) { return term.coefficient == 0.0; });
  require(top > 0.0, "a derivative with a coefficient other than zero is needed");
  const auto needed = static_cast<std::size_t>(std::ceil(top));
  require(equation.initial.size() >= needed, "an initial value is missing");
  equation.initial.resize(needed);
  require(std::ranges::all_of(equation.initial, [](double value) { return std::isfinite(value); }),
          "initial values have to be finite");
  for (const auto& load : equation.loads)
    require(!validation_error(load), validation_error(load).value_or(""));
  for (const double order : orders)
    require(order >= 0.0 && std::ceil(order) <= std::ceil(top), "this derivative is not known at 0");
  return equation;
}

// The Laplace transforms of the derivatives D^delta u,
//   s^delta U - sum_{k < ceil(delta)} s^(delta-1-k) u_k = s^delta [G + sum_k u_k N_k] / P,
//   P = sum_i c_i s^(o_i),  G = sum of loads coefficient Gamma(power+1) s^(-power-1),
//   N_k = -sum_{ceil(o_i) <= k} c_i s^(o_i-1-k) for k < ceil(delta), sum_{ceil(o_i) > k} c_i s^(o_i-1-k) for
//   the others.
// Unlike the difference on the left, this form has no cancellation for large s.
LinearTransform transform_of(const LinearEquation& equation, const std::vector<double>& orders) {
  LinearTransform transform;
  for (const auto& [coefficient, order, time_scale] : equation.terms) {
    const Rational exponent = shortest_decimal(order);
    const Coefficient scale = coefficient_of_power(shortest_decimal(time_scale), exponent);
    add_term(transform.characteristic, exponent, scale, shortest_decimal(coefficient));
    transform.generators.push_back(exponent);
  }
  auto& start = transform.group_at(0, orders.size()).numerators;
  for (std::size_t j = 0; j < orders.size(); ++j) {
    const Rational delta = shortest_decimal(orders[j]);
    transform.generators.push_back(delta);
    for (std::size_t k = 0; k < equation.initial.size(); ++k) {
      const int taken = static_cast<int>(k);
      const bool removed = taken < ceiling(delta);
      const Rational value = shortest_decimal(equation.initial[k]);
      for (const auto& [order, coefficient] : transform.characteristic) {
        if (removed == (ceiling(order) > taken)) continue;
        add_term(start[j], Rational(delta + order - 1 - taken), coefficient,
                 removed ? Rational(-value) : value);
      }
    }
  }
  for (const auto& [coefficient, power, from, over_gamma] : equation.loads) {
    auto& numerators = transform.group_at(shortest_decimal(from), orders.size()).numerators;
    const Rational next = shortest_decimal(power) + 1;
    for (std::size_t j = 0; j < orders.size(); ++j) {
      add_term(numerators[j], Rational(shortest_decimal(orders[j]) - next),
               coefficient_of_gamma(over_gamma ? Rational(1) : next), shortest_decimal(coefficient));
    }
  }
  return transform;
}

}  // namespace

Reference linear_reference(const LinearEquation& equation, const std::vector<double>& orders) {
  return linear_reference(
      name, [equation = checked(equation, orders), orders] { return transform_of(equation, orders); });
}

}  // namespace fde::reference
