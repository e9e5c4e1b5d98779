#include "problem/multipliers.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "problem/jacobian.hpp"

namespace fde {
namespace {

Vec rhs_at(const Problem& problem, double t, const Vec& y) {
  Vec f(problem.size());
  problem.rhs(t, y, f);
  return f;
}

std::vector<Eigen::Index> algebraic_rows(const Problem& problem) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    if (algebraic(problem.components[static_cast<std::size_t>(i)])) rows.push_back(i);
  }
  return rows;
}

// What the unknowns answer to constraints that are off: a column a constraint.
Matrix answers(const Problem& problem, const Matrix& jacobian, const std::vector<Eigen::Index>& constraints,
               double length) {
  Vec mass = Vec::Ones(problem.size()), scale(problem.size());
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const double order = problem.components[static_cast<std::size_t>(i)].order;
    scale[i] = std::pow(length, order) / std::tgamma(order + 1.0);
  }
  for (const auto i : constraints) mass[i] = 0.0;
  const Matrix equations = Matrix(mass.asDiagonal()) - scale.asDiagonal() * jacobian;
  const Matrix off = Matrix::Identity(problem.size(), problem.size())(Eigen::all, constraints);
  return equations.partialPivLu().solve(off);
}

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

// The lengths are so far apart that other powers of h beside the leading one do not count, nor the sign of
// what they add.
double integrated_orders(const Problem& problem) {
  constexpr double shorter = 1e-60, longer = 1e-20;  // of the end
  const auto constraints = algebraic_rows(problem);
  const Matrix jacobian = jacobian_at(problem, 0.0, taylor_part(problem, 0.0));
  const Matrix after_shorter = answers(problem, jacobian, constraints, shorter * problem.end),
               after_longer = answers(problem, jacobian, constraints, longer * problem.end);
  double most = 0.0;
  for (const auto i : multipliers(problem)) {
    const double grown =
        after_shorter.row(i).lpNorm<Eigen::Infinity>() / after_longer.row(i).lpNorm<Eigen::Infinity>();
    const double orders = std::log(grown) / std::log(longer / shorter);
    if (std::isnan(orders)) return orders;
    most = std::max(most, orders);
  }
  return most;
}

}  // namespace fde
