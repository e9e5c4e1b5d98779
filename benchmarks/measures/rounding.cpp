#include "measures/rounding.hpp"

namespace fde {

Problem in_units_of(double unit, const Problem& problem) {
  Problem other = problem;
  for (auto& component : other.components) {
    for (double& value : component.initial) value /= unit;
  }
  other.rhs = [unit, rhs = problem.rhs](double t, In u, Out f) {
    rhs(t, unit * u, f);
    f /= unit;
  };
  if (problem.jacobian) {
    other.jacobian = [unit, jacobian = problem.jacobian](double t, In u, OutMatrix by_u) {
      jacobian(t, unit * u, by_u);
    };
  }
  if (problem.sparse_jacobian) {
    other.sparse_jacobian = [unit, jacobian = problem.sparse_jacobian](double t, In u, SparseMatrix& by_u) {
      jacobian(t, unit * u, by_u);
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
  return other;
}

}  // namespace fde
