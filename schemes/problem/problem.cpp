#include "problem.hpp"

#include <cmath>

namespace fde {

std::size_t initial_count(double order) { return static_cast<std::size_t>(std::ceil(order)); }

Vec taylor_part(const Problem& problem, double t) {
  Vec sum(problem.size());
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const auto& initial = problem.components[static_cast<std::size_t>(i)].initial;
    double value = 0.0;
    for (std::size_t k = initial.size(); k-- > 0;)
      value = initial[k] + value * t / static_cast<double>(k + 1);
    sum[i] = value;
  }
  return sum;
}

}  // namespace fde
