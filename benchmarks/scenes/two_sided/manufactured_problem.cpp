// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/two_sided/manufactured_problem.hpp"

#include <cmath>

namespace fde::bench {

ManufacturedProblem manufactured_problem(const std::vector<ManufacturedRow>& rows, double end) {
  const auto size = static_cast<Eigen::Index>(rows.size());
  const auto time_from_side = [end](const ManufacturedRow& row, double t) {
    return row.side == Side::left ? t : end - t;
  };
  const auto exact = [=](double t) -> Vec {
    return Vec::NullaryExpr(size, [&](Eigen::Index i) {
      const auto& row = rows[static_cast<std::size_t>(i)];
      return 1.0 + 0.25 * static_cast<double>(i) + std::pow(time_from_side(row, t), row.power);
    });
  };
  const auto coupling = [size](const Vec& y) -> Vec {
    return Vec::NullaryExpr(
        size, [&](Eigen::Index i) { return std::sin(y[(i + 1) % size]) * y[(i + 2) % size] / 2 - y[i]; });
  };
  ManufacturedProblem made;
  made.exact = exact;
  made.problem.end = end;
  made.problem.rhs = [=](double t, In y, Out f) {
    f = coupling(y) - coupling(exact(t));
    for (Eigen::Index i = 0; i < size; ++i) {
      const auto& row = rows[static_cast<std::size_t>(i)];
      const double p = row.power, g = row.order;
      f[i] += std::tgamma(p + 1) / std::tgamma(p + 1 - g) * std::pow(time_from_side(row, t), p - g);
    }
  };
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto& row = rows[static_cast<std::size_t>(i)];
    std::vector<double> initial{1.0 + 0.25 * static_cast<double>(i)};
    if (row.order > 1.0) initial.push_back(0.0);
    made.problem.components.push_back({row.order, initial, row.side});
    made.smoothness.powers.push_back({row.power});
  }
  return made;
}

ManufacturedProblem smooth_two_sided() {
  return manufactured_problem({{0.6, 3.0, Side::left},
                               {0.5, 3.0, Side::right},
                               {1.0, 3.0, Side::left},
                               {1.7, 3.5, Side::right},
                               {1.4, 3.0, Side::left},
                               {1.0, 4.0, Side::right}},
                              1.0);
}

}  // namespace fde::bench
