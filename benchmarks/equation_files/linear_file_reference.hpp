// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_system.hpp"
#include "fdebench/reference/reference.hpp"

namespace fde::bench {

// The exact solution in these columns, derivatives of unknowns, if the equations are linear in the unknowns
// with constant coefficients and loads c t^p, or c switched on at a time: an inverse Laplace transform.
// nullopt otherwise, or for more than 12 rows. Coefficients, orders, initial values and loads are the
// fractions that the file writes: 0.1 is one tenth, 1/3 a third; a coefficient c*tau^q of D^q and a load
// c/gamma(p + 1)*t^p are exact too. If another number is no fraction, for instance sqrt(2), the reference has
// no `digits`.
std::optional<reference::Reference> linear_file_reference(const EquationText& text,
                                                          const Parameters& parameters,
                                                          const Problem& problem,
                                                          const std::vector<SystemColumn>& columns);

// Rows D^(upper - lower) y_i = rows[i] that are linear in y with constant coefficients, or algebraic where
// the order is 0; outputs: the rows that are columns.
struct LinearRows {
  std::vector<std::pair<double, double>> orders{};  // lower, upper
  std::vector<Component> components{};
  std::vector<Expression> rows{};
  std::map<std::size_t, Expression> initial{};  // initial values that are computed, by row
  std::vector<std::size_t> outputs{};
  std::vector<ValueAtEnd> final{};                       // with the unknown initial values of the components
  double end = std::numeric_limits<double>::infinity();  // of the values at the end, and of steps by floor
};

// The same for such rows. Preconditions: they are linear, and the pool has fractions.
std::optional<reference::Reference> linear_rows_reference(const LinearRows& rows, ExpressionPool& pool);

}  // namespace fde::bench
