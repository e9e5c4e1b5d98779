// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/symbols/rule_symbols.hpp"
#include "fdebench/schemes/rules/implicit/implicit_rule.hpp"
#include "fdebench/schemes/rules/implicit/piecewise_constant_multipliers.hpp"
#include "fdebench/schemes/rules/two_sided/global_solver.hpp"

namespace fde {

// y_n = T_n + h^g/Gamma(g+2) (a_{0,n} f_0 + sum_{1<=j<n} a_{n-j} f_j + f(t_n, y_n)): the corrector of
// adams_pc as an implicit rule. Multipliers are constant on each step
// (rules/implicit/piecewise_constant_multipliers.hpp).
Scheme product_trapezoidal() {
  return {
      .id = "product_trapezoidal",
      .title = "Product trapezoidal rule",
      .source = "Young, Proc. R. Soc. A 224 (1954); weights as in Yin, Liu & Anh 2007, eq. 3.7",
      .capabilities = {.implicit = true, .algebraic_rows = true, .is_two_sided = true, .checkpoints = true},
      .expected_rate = expected_rate(trapezoidal_theory),
      .solve = on_grid([](const Problem& problem, const Grid& grid, const Options& options) {
        if (is_two_sided(problem)) return solve_globally(problem, grid, options, families::trapezoid);
        return solve_product_trapezoidal(problem, grid, options);
      }),
      .unsupported_problem_reason = unsupported_multipliers_reason,
      .symbol = [](const Problem& problem, double length) {
        return implicit_symbol(problem, families::trapezoid, length);
      }};
}

}  // namespace fde
