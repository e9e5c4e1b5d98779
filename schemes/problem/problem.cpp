#include "problem/problem.hpp"

#include <algorithm>
#include <cmath>

namespace fde {

bool linear(const Problem& problem) { return problem.linear_part || problem.sparse_linear_part; }

bool sparse(const Problem& problem) { return problem.sparse_jacobian || problem.sparse_linear_part; }

bool has_jacobian(const Problem& problem) {
  return linear(problem) || problem.jacobian || problem.sparse_jacobian;
}

bool evaluate_jacobian(const Problem& problem, double t, In y, OutMatrix jacobian) {
  if (problem.linear_part) {
    jacobian = *problem.linear_part;
  } else if (problem.sparse_linear_part) {
    jacobian = Matrix(*problem.sparse_linear_part);
  } else if (problem.jacobian) {
    problem.jacobian(t, y, jacobian);
  } else if (problem.sparse_jacobian) {
    SparseMatrix entries(y.size(), y.size());
    problem.sparse_jacobian(t, y, entries);
    jacobian = Matrix(entries);
  }
  return has_jacobian(problem);
}

std::size_t initial_count(double order) { return static_cast<std::size_t>(std::max(std::ceil(order), 1.0)); }

bool two_sided(const Problem& problem) {
  return problem.conditions || std::ranges::any_of(problem.components, [](const auto& component) {
           return component.side == Side::right;
         });
}

Eigen::Index unknown_count(const Problem& problem) {
  Eigen::Index count = 0;
  for (const auto& component : problem.components) {
    const auto given = component.initial.size(), needed = initial_count(component.order);
    if (given < needed) count += static_cast<Eigen::Index>(needed - given);
  }
  return count;
}

TaylorPart::TaylorPart(const Problem& problem) {
  std::size_t powers = 1;
  for (const auto& component : problem.components) powers = std::max(powers, component.initial.size());
  coefficients_.setZero(problem.size(), static_cast<Eigen::Index>(powers));
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const auto& initial = problem.components[static_cast<std::size_t>(i)].initial;
    double factorial = 1.0;
    for (std::size_t k = 0; k < initial.size(); factorial *= static_cast<double>(++k)) {
      coefficients_(i, static_cast<Eigen::Index>(k)) = initial[k] / factorial;
    }
  }
}

void TaylorPart::at(double t, Out value) const {
  value = coefficients_.rightCols(1);
  for (Eigen::Index k = coefficients_.cols() - 1; k-- > 0;) value = coefficients_.col(k) + t * value;
}

Vec taylor_part(const Problem& problem, double t) {
  const TaylorPart part(problem);
  Vec value(problem.size()), right(problem.size());
  part.at(t, value);
  part.at(problem.end - t, right);
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    if (problem.components[static_cast<std::size_t>(i)].side == Side::right) value[i] = right[i];
  }
  return value;
}

}  // namespace fde
