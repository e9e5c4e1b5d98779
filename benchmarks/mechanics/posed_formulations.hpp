// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fdebench/benchmarks/mechanics/dynamics.hpp"
#include "fdebench/benchmarks/mechanics/mechanical_system.hpp"
#include "fdebench/benchmarks/mechanics/motion_start.hpp"
#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

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
  // Adds a row for each coordinate, with these initial values, and returns their variables.
  Expressions add_rows(ExpressionPool& pool, StateRow row, double order, const Vec& initial);
  // Appends the right-hand sides of the next rows.
  void append(const Expressions& rates) { rhs.insert(rhs.end(), rates.begin(), rates.end()); }
};

// The expressions in terms of the state of a formulation, from its columns.
Expressions in_state(const PosedEquations& equations, const Expressions& of, const Algebra& algebra);
ExpressionMatrix in_state(const PosedEquations& equations, ExpressionMatrix of, const Algebra& algebra);

// Adds rows for the memory terms of orders up to `highest` except those of order 1: D^(1 - order) w = v, w(0)
// = 0, and above order 1 D^(2 - order) w = v'. Their variables, one a memory term; 0 for the others.
std::vector<int> add_memory_rows(PosedEquations& equations, const MechanicalSystem& system,
                                 double highest = 2.0);

// Appends the right-hand sides of these rows, where v and v' are expressions of the state. `memory`: the
// variables of the rows.
void append_memory_rates(PosedEquations& equations, const std::vector<int>& memory,
                         const MechanicalSystem& system, const Expressions& velocity,
                         const Expressions& acceleration);

// The columns from the expressions of q, v and the variables of the memory rows.
Expressions columns_from(const Expressions& position, const Expressions& velocity,
                         const std::vector<int>& memory, const MechanicalSystem& system,
                         const Algebra& algebra);

// The equations of one system in several formulations (docs/mechanics.md). All throw std::invalid_argument if
// the formulation does not exist for any values of the parameters, and state an `ill_posed_reason` if it does
// not for these.
// For constraints that are affine in the velocity, f = a(t, q) v + beta(t, q, w) (Tarasov & Zaslavsky 38),
// and no force_order_with_memory_rates:
//   q' = v = P z - a^# beta,  z' = P (free acceleration) + P' v,  and the rows of w,
// with the projector P = I - a^# a, a^# = G^-1 a^T (a G^-1 a^T)^-1. z(0) = P v(0). For constant a and f = a.v
// + b.w - C0 this is q' = z - A w, z' = -P grad u with A = a b^T/|a|^2, and no term is singular.
PosedEquations integrated_equations(const Dynamics& dynamics);

// v' = free acceleration + the reaction that gives df/dt + kappa f = 0; kappa = 0 is the printed form (37,
// 42). Without memory in the constraints the rows are q' = v and v'. With orders a_1 < a_2 < ... below 1 the
// rows of a coordinate are D^a_1 v = s_1, D^(a_2 - a_1) s_1 = s_2, ..., D^(1 - a_m) s_m = v'. The terms c_k
// t^(1 - a_k - a_j) / Gamma(2 - a_k - a_j) of s_j, with c_k from singular_directions, are subtracted from the
// state. The right-hand side of the last row, v' without its unbounded part, starts like t^(1 - a_k - a_m):
// the form is well posed if all these are above 0, and no D^b q of a force with b above 1 contains an
// unbounded v'.
PosedEquations acceleration_equations(const Dynamics& dynamics, double kappa);

// q' = v, v' = free acceleration + G^-1 (df/dv)^T lambda, 0 = f, and the rows of w.
PosedEquations multiplier_equations(const Dynamics& dynamics);

// One constraint a.v + b.w + sum_k b_k.w_k + c(t) = 0 with constant coefficients, w of one order alpha in (1,
// 2) and w_k of orders below 1; w = D^(alpha-1) v. With z = P v, chi = b.v and W = P w:
//   q' = v = z + a^# (a.v),  a.v = (chi - b.z) / (b.a^#),
//   z' = P (free acceleration),  D^(2-alpha) W = P (free acceleration),  D^(alpha-1) chi = b.w.
// It needs b.a^# != 0: otherwise the constraint contains no derivative of order alpha along a^#.
PosedEquations integrated_above_one(const Dynamics& dynamics);

// The multiplier formulation of the same: D^(alpha-1) v = w, D^(2-alpha) w = v' without its part
// t^(alpha-2)/Gamma(alpha-1) w(0), which is along the reaction: the multiplier is lambda without that part.
PosedEquations multiplier_above_one(const Dynamics& dynamics);

// lambda(0) of a constraint of order above 1; nullopt if it is unbounded.
std::optional<Vec> initial_multiplier_above_one(const Dynamics& dynamics);

// The equations in the chosen formulation.
PosedEquations posed(const Dynamics& dynamics, const FormulationChoice& choice);

// The formulation in which a reference is computed: integrated if it exists, otherwise acceleration where it
// is well posed, otherwise multiplier.
Formulation reference_formulation(const Dynamics& dynamics);

}  // namespace fde::bench::mechanics
