// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/multi_term/integrated_equations.hpp"
#include "fdebench/schemes/rules/multi_term/multi_term_rates.hpp"
#include "fdebench/schemes/rules/multi_term/multi_term_solvers.hpp"
#include "fdebench/schemes/rules/multi_term/multi_term_symbols.hpp"

namespace fde {

// multi_term_trapezoidal with the force evaluated at a prediction; the linear terms are implicit.
Scheme multi_term_pc() {
  return {.id = "multi_term_pc",
          .title = "Direct multi-term predictor-corrector",
          .source = "Diethelm & Ford, Appl. Math. Comput. 154 (2004); Garrappa, Mathematics 6(2) 16 (2018)",
          .capabilities = {.discretises_equations = true, .checkpoints = true},
          .expected_rate = multi_term_trapezoidal_rate,
          .solve = on_grid(predict_and_correct_equations),
          .unsupported_problem_reason = unsupported_equations_reason,
          .symbol = predicted_multi_term_symbol};
}

}  // namespace fde
