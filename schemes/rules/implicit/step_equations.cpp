// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/implicit/step_equations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fdebench/schemes/history/parallel_for_rows.hpp"

namespace fde {
namespace {

// The larger one; NaN where either is NaN.
double larger(double a, double b) { return a >= b || std::isnan(a) ? a : b; }

}  // namespace

RowScales::RowScales(const Problem& problem)
    : algebraic(algebraic_rows(problem)),
      mass(Vec::Ones(problem.size())),
      scale(problem.size()),
      weight(Vec::Ones(problem.size())) {
  mass(algebraic).setZero();
}

void compute_residual(const StepEquations& step, const RowScales& rows, In f, In y, Out rest) {
  for_each_row(rest.size(), [&](Eigen::Index i) {
    rest.coeffRef(i) = step.known.coeff(i) + step.kappa.coeff(i) * f.coeff(i) - y.coeff(i);
  });
  for (const auto i : rows.algebraic) rest[i] = rows.scale[i] * f[i];
}

bool equations_hold(const StepEquations& step, In f, In y, double tolerance) {
  bool hold = true;
  for (Eigen::Index i = 0; i < y.size() && hold; ++i)
    hold = equation_holds(step.known.coeff(i), step.kappa.coeff(i) * f.coeff(i), y.coeff(i), tolerance);
  return hold;
}

double relative_norm(const RowScales& rows, In increment, In y) {
  // For smaller numbers rounding errors are subnormal: they are relative to this value.
  static constexpr double smallest =
      std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();
  const auto of = [](double part, double size) { return part / std::max(size, smallest); };
  double size = 0.0, part = 0.0;
  for_each_component(y.size(), [&](Eigen::Index i) {
    size = larger(size, rows.mass.coeff(i) * std::abs(y.coeff(i)));
    part = larger(part, rows.mass.coeff(i) * std::abs(increment.coeff(i)));
  });
  double largest = of(part, size);
  for (const auto i : rows.algebraic) {
    const double weight = rows.weight[i];
    const double relative = of(weight * std::abs(increment[i]), std::max(size, weight * std::abs(y[i])));
    if (!(relative <= largest)) largest = relative;
  }
  return largest;
}

}  // namespace fde
