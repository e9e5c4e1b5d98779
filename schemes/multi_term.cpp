// SPDX-License-Identifier: MIT
#include <utility>

#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/rules/implicit/newton.hpp"
#include "fdebench/schemes/rules/multi_term/integrated_equations.hpp"
#include "fdebench/schemes/rules/multi_term/multi_term_rates.hpp"
#include "fdebench/schemes/rules/multi_term/multi_term_symbols.hpp"
#include "fdebench/schemes/stepping/grid_jumps.hpp"
#include "fdebench/schemes/stepping/run.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

namespace {

// Solves the integrated equations of a problem (integrated_equations.hpp) with the weights of one family,
// each step by Newton's method. A multistep rule has starting weights, and its first steps are one system
// (starting_procedure.hpp).
Trajectory solve_integrated_equations(const Problem& problem, const Grid& grid, const Options& options,
                                      const WeightFamily& family);

// The first steps of a rule with starting weights, one column each.
Matrix first_steps_of(Run& run, IntegratedEquations& equations, const Problem& problem,
                      const Problem& stepped, const Grid& grid, double tolerance, SolveStatus& ending) {
  auto system = equations.first_equations();
  if (!system) {
    ending = SolveStatus::step_too_large;
    return {};
  }
  const auto first_order = [&](const Grid& steps, const Options& exact) {
    return solve_integrated_equations(problem, steps, exact, families::grunwald_letnikov);
  };
  return StartingProcedure(stepped, grid, std::move(*system), first_order).solve(run, tolerance, ending);
}

Trajectory solve_integrated_equations(const Problem& problem, const Grid& grid, const Options& options,
                                      const WeightFamily& family) {
  std::vector<double> powers;  // none without starting weights
  if (family.multistep != nullptr)
    powers = starting_powers_of_equations(family, problem).for_steps(grid.steps);
  const Problem stepped = integrated_problem(problem);
  Run run(stepped, options, grid.steps);
  NewtonSolver newton(stepped, options.newton_tolerance);
  const GridJumps jumps(problem, grid);
  IntegratedEquations equations(problem, family, grid, options, powers);
  run.cost().history_bytes = equations.bytes();
  run.cost().history = name(equations.history_kind());
  if (!powers.empty()) run.cost().starting_weights = static_cast<int>(powers.size());

  Matrix first;
  SolveStatus ending = SolveStatus::finished;
  Vec y = run.start();
  double t = 0.0;
  int n = 1;
  const StateArchiver state = [&](Archive& archive) {
    archive.count(n, 1, grid.steps);
    archive(t, y, newton, equations);
    archive.resizable(first);
  };
  if (!run.resume_from_checkpoint(state) && powers.size() > 1)
    first = first_steps_of(run, equations, problem, stepped, grid, options.newton_tolerance, ending);
  for (; n <= grid.steps && ending == SolveStatus::finished; ++n) {
    run.offer_checkpoint(state);
    equations.push(t, y, newton.rhs_at_solution(run, t, y));
    t = grid.time(n);
    if (n <= first.cols()) {
      y = first.col(n - 1);
    } else {
      ending = SolveStatus::step_too_large;
      if (equations.prepare_step(n))
        ending = newton.solve(run, {t, equations.kappa(), equations.known(), jumps.before(t)}, y);
    }
    if (ending == SolveStatus::finished && !run.accept(t, newton.delivered(y))) return run.finish();
  }
  if (ending != SolveStatus::finished) run.fail(ending, t > 0.0 ? t : grid.time(1));
  return run.finish();
}

// Predictor-corrector method with the trapezoidal weights. Only g is predicted, by the line through its last
// two values; the terms of the equation are linear in the unknown and are solved exactly:
//   y^P = known + kappa (f_(n-1) + h_n/h_(n-1) (f_(n-1) - f_(n-2))),   y_n = known + kappa f(t_n, y^P).
// options.corrections: how often the second equation is applied.
Trajectory predict_and_correct_equations(const Problem& problem, const Grid& grid, const Options& options) {
  const Problem stepped = integrated_problem(problem);
  Run run(stepped, options, grid.steps);
  IntegratedEquations equations(problem, families::trapezoid, grid, options);
  run.cost().history_bytes = equations.bytes();
  run.cost().history = name(equations.history_kind());

  const GridJumps jumps(problem, grid);
  Vec y = run.start(), delivered, f = Vec::Zero(y.size()), before = f;
  double t = 0.0;
  int n = 1;
  const StateArchiver state = [&](Archive& archive) {
    archive.count(n, 1, grid.steps);
    archive(t, y, f, equations);
  };
  for (run.resume_from_checkpoint(state); n <= grid.steps; ++n) {
    run.offer_checkpoint(state);
    before = f;
    f = run.rhs(t, y);
    equations.push(t, y, f);
    t = grid.time(n);
    if (!equations.prepare_step(n)) {
      run.fail(SolveStatus::step_too_large, t);
      break;
    }
    const double ratio = n == 1 ? 0.0 : grid.step(n) / grid.step(n - 1);
    if (n == 1) before = f;
    y = equations.known() + equations.kappa().cwiseProduct(f + ratio * (f - before));
    const auto correct = [&](double time) {
      for (int correction = 0; correction < options.corrections; ++correction)
        y = equations.known() + equations.kappa().cwiseProduct(run.rhs(time, y));
    };
    const bool jump = jumps.correct(t, y, delivered, correct);
    if (!run.accept(t, jump ? delivered : y)) break;
  }
  return run.finish();
}

constexpr std::string_view of_product_rules =
    "Diethelm & Ford, Appl. Math. Comput. 154 (2004); Garrappa, Mathematics 6(2) 16 (2018)";

constexpr Capabilities any_grid{.discretises_equations = true, .implicit = true, .checkpoints = true},
    uniform_grids{.discretises_equations = true, .uniform_grid = true, .implicit = true, .checkpoints = true};

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
                      .capabilities = any_grid,
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
       .capabilities = uniform_grids,
       .expected_rate = multi_term_grunwald_letnikov_rate},
      families::grunwald_letnikov);
}

// Fractional BDF2 with starting weights.
Scheme multi_term_bdf2() {
  return with_family(
      {.id = "multi_term_bdf2",
       .title = "Direct multi-term fractional BDF2 with start weights",
       .source = "Diethelm & Ford, Appl. Math. Comput. 154 (2004); Lubich, SIAM J. Math. Anal. 17 (1986)",
       .capabilities = uniform_grids,
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
