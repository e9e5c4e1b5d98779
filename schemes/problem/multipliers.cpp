// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/multipliers.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {
namespace {

// The change of all unknowns for a unit residual of each constraint, one column a constraint, where integrals
// over a step of this length replace the derivatives.
Matrix answers(const Problem& problem, const Matrix& jacobian, const std::vector<Eigen::Index>& constraints,
               double length) {
  Vec mass = Vec::Ones(problem.size()), scale(problem.size());
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const double order = problem.component(i).order;
    scale[i] = std::pow(length, order) / std::tgamma(order + 1.0);
  }
  for (const auto i : constraints) mass[i] = 0.0;
  const Matrix equations = Matrix(mass.asDiagonal()) - scale.asDiagonal() * jacobian;
  const Matrix off = Matrix::Identity(problem.size(), problem.size())(Eigen::all, constraints);
  return equations.partialPivLu().solve(off);
}

// The exponent p with which these changes grow like h^-p as the step length h -> 0. The two lengths are so
// far apart that powers of h other than the leading one are negligible.
class Growth {
 public:
  explicit Growth(const Problem& problem) {
    const auto constraints = algebraic_rows(problem);
    const Matrix jacobian = jacobian_at(problem, 0.0, taylor_part(problem, 0.0));
    after_shorter_ = answers(problem, jacobian, constraints, shorter * problem.end);
    after_longer_ = answers(problem, jacobian, constraints, longer * problem.end);
  }

  // The exponent of an unknown, over all constraints or for the constraint of one column.
  [[nodiscard]] double orders(Eigen::Index unknown) const {
    return orders_of(after_shorter_.row(unknown).lpNorm<Eigen::Infinity>(),
                     after_longer_.row(unknown).lpNorm<Eigen::Infinity>());
  }
  [[nodiscard]] double orders(Eigen::Index unknown, Eigen::Index column) const {
    return orders_of(std::abs(after_shorter_(unknown, column)), std::abs(after_longer_(unknown, column)));
  }

 private:
  static constexpr double shorter = 1e-60, longer = 1e-20;  // of the end
  static double orders_of(double after_shorter, double after_longer) {
    return std::log(after_shorter / after_longer) / std::log(longer / shorter);
  }

  Matrix after_shorter_, after_longer_;
};

}  // namespace

std::vector<Eigen::Index> multipliers(const Problem& problem) {
  const auto constraints = algebraic_rows(problem);
  const Vec start = taylor_part(problem, 0.0);
  std::vector<Eigen::Index> found;
  const auto holds = [&](double t, Eigen::Index i, double part) {
    Vec moved = start;
    moved[i] += part * std::max(1.0, std::abs(start[i]));
    const Vec before = rhs_at(problem, t, start), after = rhs_at(problem, t, moved);
    return std::ranges::any_of(constraints, [&](Eigen::Index row) { return after[row] != before[row]; });
  };
  for (const auto i : constraints) {
    const bool held = std::ranges::any_of(std::initializer_list<double>{0.0, 0.37}, [&](double share) {
      const double t = share * problem.end;
      return holds(t, i, 0.5) || holds(t, i, -1.25);
    });
    if (!held) found.push_back(i);
  }
  return found;
}

double multiplier_integration_order(const Problem& problem) {
  const Growth growth(problem);
  double most = 0.0;
  for (const auto i : multipliers(problem)) {
    const double orders = growth.orders(i);
    if (std::isnan(orders)) return orders;
    most = std::max(most, orders);
  }
  return most;
}

std::optional<Eigen::Index> inconsistent_initial_row(const Problem& problem) {
  constexpr double off = 1e-8;  // of the terms of a row: initial values may be given with 8 digits only
  constexpr double once = 1.0 - 1e-6;
  const auto constraints = algebraic_rows(problem);
  const auto drivers = multipliers(problem);
  if (drivers.empty()) return std::nullopt;
  const Vec start = taylor_part(problem, 0.0), f = rhs_at(problem, 0.0, start);
  const Matrix jacobian = jacobian_at(problem, 0.0, start);
  const Growth growth(problem);
  for (std::size_t c = 0; c < constraints.size(); ++c) {
    const auto row = constraints[c];
    const double terms = jacobian.row(row).cwiseAbs().dot(start.cwiseAbs());
    const bool mended = std::ranges::any_of(constraints, [&](auto i) { return jacobian(row, i) != 0.0; });
    if (mended || !(std::abs(f[row]) > off * terms)) continue;
    const auto column = static_cast<Eigen::Index>(c);
    if (std::ranges::any_of(drivers, [&](auto i) { return growth.orders(i, column) > once; })) return row;
  }
  return std::nullopt;
}

}  // namespace fde
