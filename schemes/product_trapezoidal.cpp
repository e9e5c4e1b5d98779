#include "implicit/stepwise_multipliers.hpp"
#include "stepping/rates.hpp"
#include "two_sided/all_at_once.hpp"

namespace fde {

// y_n = T_n + h^g/Gamma(g+2) (a_{0,n} f_0 + sum_{1<=j<n} a_{n-j} f_j + f(t_n, y_n)): the corrector of
// adams_pc as an implicit rule. Multipliers are constant on each step (implicit/stepwise_multipliers.hpp).
Scheme product_trapezoidal() {
  return {
      .id = "product_trapezoidal",
      .title = "Product trapezoidal rule",
      .source = "Young, Proc. R. Soc. A 224 (1954); weights as in Yin, Liu & Anh 2007, eq. 3.7",
      .needs = {.implicit = true, .algebraic_rows = true, .two_sided = true, .checkpoints = true},
      .expected_rate = [](const Problem& problem, const Smoothness& smoothness, double grading,
                          Norm norm) { return rate(trapezoidal_theory, problem, smoothness, grading, norm); },
      .solve = on_grid([](const Problem& problem, const Grid& grid, const Options& options) {
        if (two_sided(problem)) return solve_all_at_once(problem, grid, options, families::trapezoid);
        return step_trapezoidal(problem, grid, options);
      }),
      .refuses = refusal_of_multipliers,
      .symbol = [](const Problem& problem,
                   double length) { return implicit_symbol(problem, families::trapezoid, length); }};
}

}  // namespace fde
