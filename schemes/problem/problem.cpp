#include "problem.hpp"

#include <algorithm>
#include <cmath>

namespace fde {

std::size_t initial_count(double order) { return static_cast<std::size_t>(std::max(std::ceil(order), 1.0)); }

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
  Vec value(problem.size());
  TaylorPart(problem).at(t, value);
  return value;
}

}  // namespace fde
