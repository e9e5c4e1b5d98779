// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// A row of a problem as a fractional integral of one of the unknown functions x_k of a panel,
//   y(t) = origin + sum of coefficient t^power + I^order x_k,
// or x_k itself, order 0, for an algebraic row.
struct IntegratedRow {
  struct Power {
    double coefficient, power;
  };
  Eigen::Index unknown;  // k
  double order;
  std::vector<Power> taylor_terms;

  [[nodiscard]] bool is_algebraic() const { return order == 0.0; }
};

// All rows; rhs_indices[k] is the index of the right-hand side f_i that x_k equals. x_k is D^L u for a
// multi-term equation, and all rows of its chain are integrals of it; otherwise x_k is D^gamma y_i. For an
// algebraic row the equation is f_i = 0 instead. On panels the rows are y - origin.
struct IntegratedRows {
  explicit IntegratedRows(const Problem& problem);

  std::vector<IntegratedRow> rows{};
  std::vector<Eigen::Index> rhs_indices{};
  Vec origin;  // that of the IncrementForm of the problem; 0: the problem has none

  [[nodiscard]] Eigen::Index row_count() const { return std::ssize(rows); }
  [[nodiscard]] Eigen::Index unknown_count() const { return std::ssize(rhs_indices); }

  // The rows at t without the integrals and the origin: their Taylor parts.
  [[nodiscard]] Vec taylor_part(double t) const;
};

}  // namespace fde
