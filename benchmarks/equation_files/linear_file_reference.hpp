// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_system.hpp"
#include "fdebench/reference/reference.hpp"

namespace fde::bench {

// The exact solution in these columns, derivatives of unknowns, if the equations are linear in the unknowns
// with constant coefficients and loads c t^p, or c switched on at a time: an inverse Laplace transform.
// nullopt otherwise, or for more than 12 rows. Numbers are read as their shortest decimals; a coefficient
// c*tau^q of D^q and a load c/gamma(p + 1)*t^p are those of the decimals c and tau. If a number of the
// equations is not such a decimal, for instance 1/3, the reference has no `digits`, and the effect is
// included in its bound.
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
  std::vector<std::size_t> outputs{};
};

// The same for such rows. Precondition: they are linear.
std::optional<reference::Reference> linear_rows_reference(const LinearRows& rows, ExpressionPool& pool);

}  // namespace fde::bench
