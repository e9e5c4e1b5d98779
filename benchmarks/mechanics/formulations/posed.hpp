// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/mechanics/formulations/formulation.hpp"
#include "fdebench/benchmarks/mechanics/motion.hpp"
#include "fdebench/benchmarks/mechanics/system.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/schemes/problem/linear_smoothness.hpp"

namespace fde::bench::mechanics {

// A mechanical problem with its layout, its columns q, v and, with memory, w, and its smoothness.
struct MechanicalProblem {
  Problem problem{};
  Layout layout{};
  std::function<void(double t, In y, Out columns)> columns{};
  Smoothness smoothness{};
  std::string ill_posed_reason{};  // reason why this form is not well posed; the rest is empty then
};

// Marks rows as not measured (Smoothness::unmeasured).
void exclude_from_measures(Smoothness& smoothness, RowBlock rows);

// The matrix A of a linear right-hand side A y + b(t).
Matrix linear_part_of(const Problem& problem);

// The powers of t with which the solution starts: for a linear problem those of its series, where `loads` are
// the non-constant terms of b(t); for a nonlinear problem all that may occur.
Smoothness linear_start(const Problem& problem, std::vector<PowerLoad> loads);
Smoothness nonlinear_start(const std::vector<Component>& components);

// The multiplier form with the smoothness of another form, whose rows it has; the rows of the multipliers
// follow and have no powers.
MechanicalProblem with_multipliers(MechanicalProblem form, const Smoothness& other);

// The same for order > 1, where v is a component: it has the powers of its free part z and of chi = b.v.
MechanicalProblem with_multipliers_above_one(MechanicalProblem form, const MechanicalProblem& integrated);

// The powers of the derivative of a function that starts with these powers, without the constant.
std::vector<double> powers_of_derivative(const std::vector<double>& powers);

// The powers, without the constant, with which D^order q starts, from those of the rows q.
std::vector<double> powers_of_memory(const std::vector<std::vector<double>>& powers, RowBlock q,
                                     double order);

// Column names: q1, v1, w1 for a coordinate q1; x, dx, Dalpha_x for x.
std::vector<std::string> column_names(const std::vector<std::string>& coordinates, bool memory);

// A form that is not well posed, with the reason and the formulations that are well posed. The reasons: a
// term is unbounded at t = 0; a derivative of order above 1 + alpha occurs; the constraint has no derivative
// of order alpha along a^#.
MechanicalProblem refused_as_singular(Formulation formulation, double order);
MechanicalProblem refused_above_one(Formulation formulation, double order);
MechanicalProblem refused_as_unaligned(double order);

// A form whose right-hand side contains non-constant powers of t.
template <class Form>
concept HasTimeLoads = requires(const Form& form) {
  form.loads();
};

// df/dy of a form by automatic differentiation, four columns at a time.
template <class Form>
void differentiate(const Form& form, double t, const Vector<double, Form::states>& y, OutMatrix jacobian) {
  constexpr int states = Form::states, columns = 4;
  using S = Dual<double, columns>;
  for (int first = 0; first < states; first += columns) {
    const int last = std::min(first + columns, states);
    Vector<S, states> moved = constants<columns>(y);
    for (int j = first; j < last; ++j) moved[j].set_derivative(j - first, 1.0);
    const Vector<S, states> f = form.template rhs<S>(t, moved);
    for (int i = 0; i < states; ++i) {
      for (int j = first; j < last; ++j) jacobian(i, j) = f[i].derivative(j - first);
    }
  }
}

// The problem of a form up to `end`, with its derivatives, columns and smoothness.
template <class Form>
MechanicalProblem make_problem(const Form& form, double end) {
  static_assert(Form::layout.is_partition());
  constexpr bool linear = Linear<decltype(form.system)>;
  using Unknowns = Vector<double, Form::states>;
  MechanicalProblem result;
  result.layout = Form::layout;
  result.problem.components = form.components();
  result.problem.rhs = [form](double t, In y, Out f) { f = form.template rhs<double>(t, Unknowns(y)); };
  result.problem.end = end;
  result.columns = [form](double t, In y, Out columns) {
    const auto of = form.columns(t, Unknowns(y));
    columns = stacked<double>(of.q, of.v, of.w).head(columns.size());
  };
  if constexpr (linear) {
    result.problem.derivatives = DenseLinearPart{linear_part_of(result.problem)};
  } else {
    result.problem.derivatives = DenseJacobian{
        [form](double t, In y, OutMatrix jacobian) { differentiate(form, t, Unknowns(y), jacobian); }};
  }
  if (!linear || std::ranges::any_of(result.problem.components, is_algebraic)) {
    result.smoothness = nonlinear_start(result.problem.components);
    return result;
  }
  std::vector<PowerLoad> loads;
  if constexpr (HasTimeLoads<Form>) loads = form.loads();
  result.smoothness = linear_start(result.problem, std::move(loads));
  return result;
}

}  // namespace fde::bench::mechanics
