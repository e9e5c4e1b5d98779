// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/multi_term/integrated_equations.hpp"
#include "fdebench/schemes/rules/multi_term/multi_term_rates.hpp"
#include "fdebench/schemes/rules/multi_term/multi_term_solvers.hpp"
#include "fdebench/schemes/rules/multi_term/multi_term_symbols.hpp"

namespace fde {

// Discretises each integral of rules/multi_term/integrated_equations.hpp by the product trapezoidal rule.
Scheme multi_term_trapezoidal() {
  return {.id = "multi_term_trapezoidal",
          .title = "Direct multi-term product trapezoidal rule",
          .source = "Diethelm & Ford, Appl. Math. Comput. 154 (2004); Garrappa, Mathematics 6(2) 16 (2018)",
          .capabilities = {.discretises_equations = true, .implicit = true, .checkpoints = true},
          .expected_rate = multi_term_trapezoidal_rate,
          .solve = on_grid([](const Problem& problem, const Grid& grid, const Options& options) {
            return solve_integrated_equations(problem, grid, options, families::trapezoid);
          }),
          .unsupported_problem_reason = unsupported_equations_reason,
          .symbol = [](const Problem& problem, double length) {
            return implicit_multi_term_symbol(problem, families::trapezoid, length);
          }};
}

}  // namespace fde
