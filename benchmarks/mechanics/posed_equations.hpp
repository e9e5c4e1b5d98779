// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fdebench/benchmarks/mechanics/dynamics.hpp"
#include "fdebench/schemes/problem/linear_smoothness.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde::bench::mechanics {

// What a row of a formulation is, for the coordinate `coordinate`; the multiplier and chi have no coordinate.
enum class RowKind {
  position,        // q
  velocity,        // v; with an order above 1 its row is D^(order - 1) v
  free_velocity,   // P v, the part of v that the constraints leave free
  constrained,     // chi = b.v, the part of v that a constraint of order above 1 determines
  rate,            // D^order v
  memory,          // D^order q
  free_memory,     // P D^order q
  adjoint_memory,  // the right integral of dL/dw
  momentum,        // p, or p + the integrals of dL/dw
  multiplier       // lambda
};
struct StateRow {
  RowKind kind;
  std::size_t coordinate = 0;
  double order = 0.0;
};

// The rows of a formulation, D^(order_i) y_i = rhs_i(t, y), and the columns q, v, w as functions of the state
// y: row i is variable i + 1 of these expressions.
struct PosedEquations {
  std::vector<StateRow> rows{};
  std::vector<Component> components{};
  Expressions rhs{};
  Expressions columns{};
  std::map<std::size_t, Expression>
      exact_initial{};             // initial values that are computed, by row, as fractions
  std::vector<PowerLoad> loads{};  // powers of t in the right-hand sides that are not integer
  std::string ill_posed_reason{};  // reason why this form is not well posed; the rest is empty then

  // Adds a row and returns its variable. Its right-hand side is appended to `rhs` by the caller, in the same
  // order.
  int add_row(const StateRow& row, double order, std::vector<double> initial);
};

// The expressions in terms of the state of a formulation, from its columns.
Expressions in_state(const PosedEquations& equations, const Expressions& of, const Algebra& algebra);
ExpressionMatrix in_state(const PosedEquations& equations, ExpressionMatrix of, const Algebra& algebra);

// Adds rows for all memory terms except those of order 1: D^(1 - order) w = v, w(0) = 0, and above order 1
// D^(2 - order) w = v'. Their variables, one a memory term; 0 at order 1.
std::vector<int> add_memory_rows(PosedEquations& equations, const MechanicalSystem& system);

// Appends the right-hand sides of these rows, where v and v' are expressions of the state.
void append_memory_rates(PosedEquations& equations, const MechanicalSystem& system,
                         const Expressions& velocity, const Expressions& acceleration);

// The columns from the expressions of q, v and the variables of the memory rows.
Expressions columns_from(const Expressions& position, const Expressions& velocity,
                         const std::vector<int>& memory, const MechanicalSystem& system,
                         const Algebra& algebra);

}  // namespace fde::bench::mechanics
