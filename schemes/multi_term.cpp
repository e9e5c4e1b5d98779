// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/multi_term/integrated_equations.hpp"
#include "fdebench/schemes/rules/multi_term/multi_term_rates.hpp"
#include "fdebench/schemes/rules/multi_term/multi_term_solvers.hpp"
#include "fdebench/schemes/rules/multi_term/multi_term_symbols.hpp"

namespace fde {
namespace {

constexpr std::string_view of_product_rules =
    "Diethelm & Ford, Appl. Math. Comput. 154 (2004); Garrappa, Mathematics 6(2) 16 (2018)";

constexpr Capabilities equations{.discretises_equations = true, .implicit = true, .checkpoints = true},
    equations_on_uniform_grids{
        .discretises_equations = true, .uniform_grid = true, .implicit = true, .checkpoints = true};

// Discretises each integral of rules/multi_term/integrated_equations.hpp with the weights of a family.
Scheme with_family(Scheme scheme, const WeightFamily& family) {
  scheme.solve = on_grid([&family](const Problem& problem, const Grid& grid, const Options& options) {
    return solve_integrated_equations(problem, grid, options, family);
  });
  scheme.unsupported_problem_reason = unsupported_equations_reason;
  scheme.symbol = [&family](const Problem& problem, double length) {
    return implicit_multi_term_symbol(problem, family, length);
  };
  return scheme;
}

}  // namespace

// The product trapezoidal rule.
Scheme multi_term_trapezoidal() {
  return with_family({.id = "multi_term_trapezoidal",
                      .title = "Direct multi-term product trapezoidal rule",
                      .source = of_product_rules,
                      .capabilities = equations,
                      .expected_rate = multi_term_trapezoidal_rate},
                     families::trapezoid);
}

// multi_term_trapezoidal with the force evaluated at a prediction; the linear terms are implicit.
Scheme multi_term_pc() {
  return {.id = "multi_term_pc",
          .title = "Direct multi-term predictor-corrector",
          .source = of_product_rules,
          .capabilities = {.discretises_equations = true, .checkpoints = true},
          .expected_rate = multi_term_trapezoidal_rate,
          .solve = on_grid(predict_and_correct_equations),
          .unsupported_problem_reason = unsupported_equations_reason,
          .symbol = predicted_multi_term_symbol};
}

// Backward Euler convolution quadrature.
Scheme multi_term_grunwald_letnikov() {
  return with_family(
      {.id = "multi_term_grunwald_letnikov",
       .title = "Direct multi-term Grunwald-Letnikov",
       .source = "Podlubny, Fractional Differential Equations (1999), section 8.2; Lubich 1986",
       .capabilities = equations_on_uniform_grids,
       .expected_rate = multi_term_grunwald_letnikov_rate},
      families::grunwald_letnikov);
}

// Fractional BDF2 with starting weights.
Scheme multi_term_bdf2() {
  return with_family(
      {.id = "multi_term_bdf2",
       .title = "Direct multi-term fractional BDF2 with start weights",
       .source = "Diethelm & Ford, Appl. Math. Comput. 154 (2004); Lubich, SIAM J. Math. Anal. 17 (1986)",
       .capabilities = equations_on_uniform_grids,
       .expected_rate =
           [](const Problem& problem, const Smoothness& smoothness, double grading, Norm norm) {
             return multi_term_multistep_rate(families::bdf2, problem, smoothness, grading, norm);
           },
       .starting_powers =
           [](const Problem& problem) {
             return starting_powers_of_equations(families::bdf2, problem).powers;
           }},
      families::bdf2);
}

}  // namespace fde
