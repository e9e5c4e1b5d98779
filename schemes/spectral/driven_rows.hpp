#pragma once

#include <vector>

#include "problem/problem.hpp"

namespace fde {

// A row of a problem as an integral of one of the unknown functions x_k that a panel solves for,
//   y(t) = sum of coefficient t^power + I^order x_k,
// or x_k itself, order 0, for an algebraic row.
struct DrivenRow {
  struct Power {
    double coefficient, power;
  };
  Eigen::Index drive;  // k
  double order;
  std::vector<Power> start;

  [[nodiscard]] bool algebraic() const { return order == 0.0; }
};

// All rows, and for each x_k the row of the right-hand side that it equals: D^L u of a multi-term equation,
// whose chain it drives as a whole, otherwise D^gamma y_i. An algebraic drive makes its row 0 instead.
struct DrivenRows {
  explicit DrivenRows(const Problem& problem);

  std::vector<DrivenRow> rows{};
  std::vector<Eigen::Index> drives{};

  [[nodiscard]] Eigen::Index row_count() const { return std::ssize(rows); }
  [[nodiscard]] Eigen::Index drive_count() const { return std::ssize(drives); }

  // What is known of every row at t, without the integrals.
  [[nodiscard]] Vec start(double t) const;
};

}  // namespace fde
