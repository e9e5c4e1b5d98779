// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/multi_term/integrated_equations.hpp"
#include "fdebench/schemes/rules/multi_term/multi_term_rates.hpp"
#include "fdebench/schemes/rules/multi_term/multi_term_solvers.hpp"
#include "fdebench/schemes/rules/multi_term/multi_term_symbols.hpp"

namespace fde {

// Discretises each integral of rules/multi_term/integrated_equations.hpp by backward Euler convolution
// quadrature.
Scheme multi_term_grunwald_letnikov() {
  return {.id = "multi_term_grunwald_letnikov",
          .title = "Direct multi-term Grunwald-Letnikov",
          .source = "Podlubny, Fractional Differential Equations (1999), section 8.2; Lubich 1986",
          .capabilities = {.discretises_equations = true,
                           .uniform_grid = true,
                           .implicit = true,
                           .checkpoints = true},
          .expected_rate = multi_term_grunwald_letnikov_rate,
          .solve = on_grid([](const Problem& problem, const Grid& grid, const Options& options) {
            return solve_integrated_equations(problem, grid, options, families::grunwald_letnikov);
          }),
          .unsupported_problem_reason = unsupported_equations_reason,
          .symbol = [](const Problem& problem, double length) {
            return implicit_multi_term_symbol(problem, families::grunwald_letnikov, length);
          }};
}

}  // namespace fde
