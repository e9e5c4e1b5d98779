// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/mechanical_system.hpp"

#include <cmath>
#include <limits>

#include "fdebench/benchmarks/expressions/program.hpp"

namespace fde::bench::mechanics {

Vec columns_at_start(const MechanicalSystem& system) {
  Vec columns = Vec::Zero(static_cast<Eigen::Index>(system.column_count()));
  const auto n = static_cast<Eigen::Index>(system.size());
  columns.head(n) = system.position;
  columns.segment(n, n) = system.velocity;
  for (std::size_t k = 0; k < system.memory.size(); ++k) {
    const auto& [coordinate, order] = system.memory[k];
    if (order == 1.0)
      columns[2 * n + static_cast<Eigen::Index>(k)] = system.velocity[static_cast<Eigen::Index>(coordinate)];
  }
  return columns;
}

Vec values_at(const ExpressionPool& pool, const Expressions& of, double t, In columns) {
  Vec values(std::ssize(of));
  Program(pool, of, columns.size()).evaluate(t, columns, {values.data(), of.size()});
  return values;
}

double zero_if_rounding(double sum, double size) {
  return std::abs(sum) <= 4.0 * std::numeric_limits<double>::epsilon() * size ? 0.0 : sum;
}

}  // namespace fde::bench::mechanics
