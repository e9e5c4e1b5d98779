// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/symbols/rule_symbols.hpp"
#include "fdebench/schemes/rules/implicit/implicit_rule.hpp"
#include "fdebench/schemes/rules/two_sided/global_solver.hpp"

namespace fde {

// h^(-g) sum_{k<=n} (-1)^k binomial(g, k) (y - T)_{n-k} = f(t_n, y_n), T the Taylor part, in integral form:
//   y_n = T_n + h^g sum_{1<=j<=n} (-1)^(n-j) binomial(-g, n-j) f_j.
// f_0 has weight 0, so g = 1 is the backward Euler method.
Scheme grunwald_letnikov() {
  return {
      .id = "grunwald_letnikov",
      .title = "Implicit Grunwald-Letnikov",
      .source = "Lubich, SIAM J. Math. Anal. 17 (1986): backward Euler convolution quadrature",
      .capabilities = {.uniform_grid = true,
                       .implicit = true,
                       .algebraic_rows = true,
                       .is_two_sided = true,
                       .checkpoints = true},
      .expected_rate = expected_rate(grunwald_letnikov_theory),
      .solve = on_grid([](const Problem& problem, const Grid& grid, const Options& options) {
        if (is_two_sided(problem)) return solve_globally(problem, grid, options, families::grunwald_letnikov);
        return solve_implicit(problem, grid, options, integral_rule(problem, families::grunwald_letnikov));
      }),
      .symbol = [](const Problem& problem,
                   double length) { return implicit_symbol(problem, families::grunwald_letnikov, length); },
      .alias = "bdf1"};
}

}  // namespace fde
