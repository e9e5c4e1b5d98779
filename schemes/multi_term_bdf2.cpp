// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/multi_term/integrated_equations.hpp"
#include "fdebench/schemes/rules/multi_term/multi_term_rates.hpp"
#include "fdebench/schemes/rules/multi_term/multi_term_solvers.hpp"
#include "fdebench/schemes/rules/multi_term/multi_term_symbols.hpp"

namespace fde {

// Discretises each integral of rules/multi_term/integrated_equations.hpp by fractional BDF2 with starting
// weights.
Scheme multi_term_bdf2() {
  return {.id = "multi_term_bdf2",
          .title = "Direct multi-term fractional BDF2 with start weights",
          .source = "Diethelm & Ford, Appl. Math. Comput. 154 (2004); Lubich, SIAM J. Math. Anal. 17 (1986)",
          .capabilities = {.discretises_equations = true,
                           .uniform_grid = true,
                           .implicit = true,
                           .checkpoints = true},
          .expected_rate =
              [](const Problem& problem, const Smoothness& smoothness, double grading, Norm norm) {
                return multi_term_multistep_rate(families::bdf2, problem, smoothness, grading, norm);
              },
          .solve = on_grid([](const Problem& problem, const Grid& grid, const Options& options) {
            return solve_integrated_equations(problem, grid, options, families::bdf2);
          }),
          .unsupported_problem_reason = unsupported_equations_reason,
          .symbol = [](const Problem& problem,
                       double length) { return implicit_multi_term_symbol(problem, families::bdf2, length); },
          .starting_powers =
              [](const Problem& problem) {
                return starting_powers_of_equations(families::bdf2, problem).powers;
              }};
}

}  // namespace fde
