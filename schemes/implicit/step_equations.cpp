#include "implicit/step_equations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fde {

RowScales::RowScales(const Problem& problem)
    : mass(Vec::Ones(problem.size())), scale(problem.size()), weight(Vec::Ones(problem.size())) {
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    if (!fde::algebraic(problem.components[static_cast<std::size_t>(i)])) continue;
    algebraic.push_back(i);
    mass[i] = 0.0;
  }
}

void take_residual(const StepEquations& step, const RowScales& rows, In f, In y, Out rest) {
  rest = step.past + step.kappa.cwiseProduct(f) - y;
  for (const auto i : rows.algebraic) rest[i] = rows.scale[i] * f[i];
}

bool holds(const StepEquations& step, In f, In y, double tolerance) {
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const double part = step.kappa[i] * f[i], terms = std::abs(step.past[i]) + std::abs(part);
    const double rest = std::abs(step.past[i] + part - y[i]);
    if (!(rest <= tolerance * terms && std::isfinite(terms))) return false;
  }
  return true;
}

double relative_size(const RowScales& rows, In increment, In y) {
  // Below, doubles lose their digits one by one: rounding is relative to this then.
  static constexpr double smallest =
      std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();
  const auto of = [](double part, double size) { return part / std::max(size, smallest); };
  const double size = rows.mass.cwiseProduct(y).lpNorm<Eigen::Infinity>();
  double largest = of(rows.mass.cwiseProduct(increment).lpNorm<Eigen::Infinity>(), size);
  for (const auto i : rows.algebraic) {
    const double weight = rows.weight[i];
    const double relative = of(weight * std::abs(increment[i]), std::max(size, weight * std::abs(y[i])));
    if (!(relative <= largest)) largest = relative;
  }
  return largest;
}

}  // namespace fde
