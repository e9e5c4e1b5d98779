// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/rounding.hpp"

namespace fde::bench {
namespace {

// A constant matrix of derivatives does not depend on the unit; the argument of a Jacobian does.
template <class Jacobian>
Derivatives derivatives_in_units_of(double /*unit*/, const Jacobian& linear) {
  return linear;
}
Derivatives derivatives_in_units_of(double unit, const DenseJacobian& given) {
  return DenseJacobian{
      [unit, given](double t, In u, OutMatrix jacobian) { given.at(t, unit * u, jacobian); }};
}
Derivatives derivatives_in_units_of(double unit, const SparseJacobian& given) {
  return SparseJacobian{
      [unit, given](double t, In u, SparseMatrix& jacobian) { given.at(t, unit * u, jacobian); }};
}

IncrementForm increments_in_units_of(double unit, const IncrementForm& given) {
  if (!given.is_given()) return {};
  return {
      given.origin / unit,
      [unit, rhs = given.rhs](double t, In z, Out f) {
        rhs(t, unit * z, f);
        f /= unit;
      },
      [unit, jacobian = given.jacobian](double t, In z, OutMatrix values) { jacobian(t, unit * z, values); }};
}

Delays delays_in_units_of(double unit, const Delays& given) {
  const auto original = [unit](const Past& past) -> Past {
    return [unit, &past](double t, Out u) {
      past(t, u);
      u *= unit;
    };
  };
  Delays other{.lags = given.lags,
               .before =
                   [unit, before = given.before](double t, Out u) {
                     before(t, u);
                     u /= unit;
                   },
               .rhs =
                   [unit, original, rhs = given.rhs](double t, In u, const Past& past, Out f) {
                     rhs(t, unit * u, original(past), f);
                     f /= unit;
                   }};
  if (given.jacobian) {
    other.jacobian = [unit, original, jacobian = given.jacobian](double t, In u, const Past& past,
                                                                 OutMatrix values) {
      jacobian(t, unit * u, original(past), values);
    };
  }
  return other;
}

Equation equation_in_units_of(double unit, Equation equation) {
  equation.force = [unit, force = equation.force](double t, In u) { return force(t, unit * u) / unit; };
  equation.force_text = {};
  equation.factor = [unit, factor = equation.factor](double t, In u) { return factor(t, unit * u); };
  return equation;
}

}  // namespace

Problem rescaled_problem(double unit, const Problem& problem) {
  Problem other = problem;
  for (auto& component : other.components) {
    for (double& value : component.initial) value /= unit;
  }
  other.rhs = [unit, rhs = problem.rhs](double t, In u, Out f) {
    rhs(t, unit * u, f);
    f /= unit;
  };
  other.text = {};
  other.derivatives = std::visit([&](const auto& given) { return derivatives_in_units_of(unit, given); },
                                 problem.derivatives);
  other.increments = increments_in_units_of(unit, problem.increments);
  for (auto& equation : other.equations) equation = equation_in_units_of(unit, equation);
  if (const Delays& given = problem.delays; !given.lags.empty())
    other.delays = delays_in_units_of(unit, given);
  for (Reset& reset : other.resets) {
    reset.value = [unit, value = reset.value](double t, In u) { return value(t, unit * u); };
    reset.state = [unit, state = reset.state](double t, In u, Out after) {
      Vec y = unit * u;
      state(t, unit * u, y);
      after = y / unit;
    };
  }
  if (problem.conditions) {
    other.conditions = [unit, conditions = problem.conditions](In start, In end, Out residual) {
      conditions(unit * start, unit * end, residual);
    };
  }
  if (problem.domain.margin) {
    other.domain.margin = [unit, margin = problem.domain.margin](double t, In u) {
      return margin(t, unit * u);
    };
  }
  if (problem.domain.constraints) {
    other.domain.constraints = [unit, constraints = problem.domain.constraints](double t, In u) {
      return constraints(t, unit * u);
    };
  }
  return other;
}

}  // namespace fde::bench
