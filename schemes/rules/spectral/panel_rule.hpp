// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <map>
#include <vector>

#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// P_0(x) ... P_(count-1)(x), one row a point.
Matrix legendre_polynomials(const Vec& points, Eigen::Index count);

// The collocation rule of all panels: Radau points, and functions on a panel as values at these points or as
// coefficients of Legendre polynomials. Points on a panel are in (-1, 1], the last is its end. The matrices
// act on one column a function.
//
// The end is a collocation point, so the value that a panel passes on satisfies the equations. This damps
// modes that decay within the panel. With Gauss points, all inside, the value would be that of the
// extrapolated polynomial, whose error is larger than inside, and for orders above 1 grows from panel to
// panel. Algebraic rows hold at the end too, so the next panel begins without a defect that multipliers would
// correct.
struct PanelRule {
  explicit PanelRule(Eigen::Index count);

  [[nodiscard]] Eigen::Index size() const { return points.size(); }

  Vec points;              // increasing
  Matrix to_coefficients;  // from values; exact for polynomials of degree size() - 1
  Vec at_start;            // weights of the values in the polynomial's value at -1
  // Values at the points of each half from values at the points of a block.
  Matrix to_older_half, to_newer_half;
  // Coefficients of the least-squares fit on a block: the sum of the contributions of its halves.
  Matrix from_older, from_newer;
};

// The rule with this number of points, computed once. Thread-safe; the reference is valid until the program
// ends.
const PanelRule& panel_rule(Eigen::Index points);

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

  // Whether all rows are integrals of one order, row i that of x_i = f_i.
  [[nodiscard]] bool have_one_order() const;

  // The rows at t without the integrals and the origin: their Taylor parts.
  [[nodiscard]] Vec taylor_part(double t) const;
};

// The position of a panel relative to a later one, in widths of the later one: its own width, and the gap
// between the two.
struct RelativePosition {
  double width, gap;
  auto operator<=>(const RelativePosition&) const = default;
};

// The fractional integrals of functions on panels, as matrices that act on Legendre coefficients; for a panel
// of width w they are in units of (w/2)^order. The matrices are cached by relative position: where all widths
// are a power of 2 times each other, a few positions recur.
class PanelKernels {
 public:
  // The rule must outlive this object.
  PanelKernels(const PanelRule& rule, const IntegratedRows& integrated_rows);

  // The distinct orders of the rows, without 0; and the index of the order of a row among them, -1 for order
  // 0.
  [[nodiscard]] const std::vector<double>& orders() const { return orders_; }
  [[nodiscard]] Eigen::Index order_of(Eigen::Index row) const {
    return order_of_[static_cast<std::size_t>(row)];
  }

  // (w/2)^order, for every order.
  [[nodiscard]] Vec units(double width) const;

  // The integrals at the points of the panel itself, from values there.
  [[nodiscard]] const Matrix& own_integrals(Eigen::Index order) const {
    return own_integrals_[static_cast<std::size_t>(order)];
  }

  // The integrals at the points of a later panel, from Legendre coefficients, one matrix an order. The
  // reference is valid as long as this object exists.
  const std::vector<Matrix>& integrals_on(const RelativePosition& position);
  // The same, not cached.
  [[nodiscard]] std::vector<Matrix> compute_integrals(const RelativePosition& position) const;

  [[nodiscard]] std::size_t bytes() const;

 private:
  const PanelRule& rule_;
  std::vector<double> orders_;
  std::vector<Eigen::Index> order_of_;
  std::vector<Matrix> own_integrals_;
  std::map<RelativePosition, std::vector<Matrix>> cache_;
};

}  // namespace fde
