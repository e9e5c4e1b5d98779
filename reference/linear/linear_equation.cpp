// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/linear_equation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "fdebench/reference/linear/linear_solution.hpp"

namespace fde::reference {
namespace {

constexpr const char* equation_name = "linear equation";

void require_equation(bool holds, const char* message) {
  if (!holds) throw std::invalid_argument(fmt::format("{}: {}", equation_name, message));
}

void require_finite(const LinearEquation& equation) {
  for (const auto& [coefficient, order, time_scale] : equation.terms) {
    require_equation(std::isfinite(coefficient), "coefficients have to be finite");
    require_equation(order >= 0.0 && order <= 10.0, "orders have to be in [0, 10]");
    require_equation(time_scale > 0.0 && std::isfinite(time_scale), "time scales have to be positive");
  }
  require_equation(std::ranges::all_of(equation.initial, [](double value) { return std::isfinite(value); }),
                   "initial values have to be finite");
  for (const auto& load : equation.loads)
    require_equation(!validation_error(load), validation_error(load).value_or(""));
}

// The equation without its zero terms, whose orders would otherwise count. Throws std::invalid_argument.
LinearEquationOf<Rational> checked(LinearEquationOf<Rational> equation, const std::vector<Rational>& orders) {
  std::erase_if(equation.terms, [](const auto& term) { return term.coefficient == 0; });
  Rational top(0);
  for (const auto& term : equation.terms) top = std::max(top, term.order);
  require_equation(top > 0, "a derivative with a coefficient other than zero is needed");
  require_equation(top <= 10, "orders have to be in [0, 10]");
  const auto needed = static_cast<std::size_t>(ceiling(top));
  require_equation(equation.initial.size() >= needed, "an initial value is missing");
  equation.initial.resize(needed);
  for (const auto& order : orders)
    require_equation(order >= 0 && ceiling(order) <= ceiling(top), "this derivative is not known at 0");
  return equation;
}

// The Laplace transforms of the derivatives D^delta u,
//   s^delta U - sum_{k < ceil(delta)} s^(delta-1-k) u_k = s^delta [G + sum_k u_k N_k] / P,
//   P = sum_i c_i s^(o_i),  G = sum of loads coefficient Gamma(power+1) s^(-power-1),
//   N_k = -sum_{ceil(o_i) <= k} c_i s^(o_i-1-k) for k < ceil(delta), sum_{ceil(o_i) > k} c_i s^(o_i-1-k) for
//   the others.
// Unlike the difference on the left, this form has no cancellation for large s.
LinearTransform transform_of(const LinearEquationOf<Rational>& equation,
                             const std::vector<Rational>& orders) {
  LinearTransform transform;
  for (const auto& [coefficient, order, time_scale] : equation.terms) {
    add_term(transform.characteristic, order, coefficient_of_power(time_scale, order), coefficient);
    transform.generators.push_back(order);
  }
  auto& start = transform.group_at(0, orders.size()).numerators;
  for (std::size_t j = 0; j < orders.size(); ++j) {
    const Rational& delta = orders[j];
    transform.generators.push_back(delta);
    for (std::size_t k = 0; k < equation.initial.size(); ++k) {
      const int taken = static_cast<int>(k);
      const bool removed = taken < ceiling(delta);
      const Rational& value = equation.initial[k];
      for (const auto& [order, coefficient] : transform.characteristic) {
        if (removed == (ceiling(order) > taken)) continue;
        add_term(start[j], Rational(delta + order - 1 - taken), coefficient,
                 removed ? Rational(-value) : value);
      }
    }
  }
  for (const auto& [coefficient, power, from, over_gamma] : equation.loads) {
    auto& numerators = transform.group_at(from, orders.size()).numerators;
    const Rational next = power + 1;
    for (std::size_t j = 0; j < orders.size(); ++j) {
      add_term(numerators[j], Rational(orders[j] - next),
               coefficient_of_gamma(over_gamma ? Rational(1) : next), coefficient);
    }
  }
  return transform;
}

LinearEquationOf<Rational> exact(const LinearEquation& equation) {
  LinearEquationOf<Rational> same;
  for (const auto& [coefficient, order, time_scale] : equation.terms) {
    same.terms.push_back(
        {shortest_decimal(coefficient), shortest_decimal(order), shortest_decimal(time_scale)});
  }
  for (const double value : equation.initial) same.initial.push_back(shortest_decimal(value));
  for (const Load& load : equation.loads) same.loads.push_back(exact(load));
  return same;
}

}  // namespace

Reference linear_reference(const LinearEquation& equation, const std::vector<double>& orders) {
  require_finite(equation);
  std::vector<Rational> wanted;
  for (const double order : orders) wanted.push_back(shortest_decimal(order));
  return exact_linear_reference(exact(equation), wanted);
}

Reference exact_linear_reference(const LinearEquationOf<Rational>& equation,
                                 const std::vector<Rational>& orders) {
  return linear_reference(equation_name, [equation = checked(equation, orders), orders] {
    return transform_of(equation, orders);
  });
}

}  // namespace fde::reference
