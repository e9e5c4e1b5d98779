// SPDX-License-Identifier: MIT
#include <utility>
#include <vector>

#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/rules/implicit/newton_stepper.hpp"
#include "fdebench/schemes/rules/multi_term/integrated_equations.hpp"
#include "fdebench/schemes/rules/multi_term/multi_term_rates.hpp"
#include "fdebench/schemes/rules/multi_term/multi_term_symbols.hpp"
#include "fdebench/schemes/stepping/grid_stepper.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

namespace {

Trajectory solve_integrated_equations(const Problem& problem, const Grid& grid, const Options& options,
                                      const WeightFamily& family);

// The powers that starting weights of this family make exact; none without starting weights.
std::vector<double> powers_for(const WeightFamily& family, const Problem& problem, const Grid& grid) {
  if (family.multistep == nullptr) return {};
  return starting_powers_of_equations(family, problem).for_steps(grid.steps);
}

// The integrated equations of a problem (integrated_equations.hpp) with the weights of one family, each step
// by Newton's method. A multistep rule has starting weights, and its first steps are one system
// (starting_procedure.hpp).
class EquationStepper final : public NewtonStepper<EquationStepper> {
 public:
  EquationStepper(const Problem& problem, const Problem& stepped, const Grid& grid, const Options& options,
                  const WeightFamily& family)
      : NewtonStepper(stepped, grid, options),
        chains_(problem),
        powers_(powers_for(family, problem, grid)),
        equations_(problem, family, grid, options, powers_) {
    record_history(equations_.bytes(), equations_.history());
    if (!powers_.empty()) run_.cost().starting_weights = static_cast<int>(powers_.size());
  }

  StepOutcome start() {
    if (powers_.size() <= 1) return {0.0};
    auto system = equations_.first_equations();
    if (!system) return {grid().time(1), SolveStatus::step_too_large};
    const auto first_order = [&](const Grid& steps, const Options& exact) {
      return solve_integrated_equations(chains_, steps, exact, families::grunwald_letnikov);
    };
    SolveStatus ending{};
    first_ = StartingProcedure(problem_, grid(), std::move(*system), first_order)
                 .solve(run_, options_.newton_tolerance, ending);
    return {grid().time(1), ending};
  }

  SolveStatus step() {
    equations_.push(before(), y_, rhs_before());
    if (n() <= first_.cols()) {
      y_ = first_.col(n() - 1);
      return SolveStatus::finished;
    }
    if (!equations_.prepare_step(n())) return SolveStatus::step_too_large;
    return solve(equations_.kappa(), equations_.known());
  }

  void rule_state(Archive& archive) {
    NewtonStepper::rule_state(archive);
    archive(equations_);
    archive.resizable(first_);
  }

 private:
  const Problem& chains_;  // with the equations; problem_ is what each step solves
  const std::vector<double> powers_;
  IntegratedEquations equations_;
  Matrix first_{};  // the first steps of a rule with starting weights, one column each
};

Trajectory solve_integrated_equations(const Problem& problem, const Grid& grid, const Options& options,
                                      const WeightFamily& family) {
  const Problem stepped = integrated_problem(problem);
  return integrate(EquationStepper(problem, stepped, grid, options, family));
}

// Predictor-corrector method with the trapezoidal weights. Only g is predicted, by the line through its last
// two values; the terms of the equation are linear in the unknown and are solved exactly:
//   y^P = known + kappa (f_(n-1) + h_n/h_(n-1) (f_(n-1) - f_(n-2))),   y_n = known + kappa f(t_n, y^P).
// options.corrections: how often the second equation is applied.
class EquationPredictor final : public GridStepper<EquationPredictor> {
 public:
  EquationPredictor(const Problem& problem, const Problem& stepped, const Grid& grid, const Options& options)
      : GridStepper(stepped, grid, options),
        equations_(problem, families::trapezoid, grid, options),
        f_(Vec::Zero(y_.size())),
        f_before_(f_) {
    record_history(equations_.bytes(), equations_.history());
  }

  SolveStatus step() {
    f_before_ = f_;
    f_ = run_.rhs(before(), y_);
    equations_.push(before(), y_, f_);
    if (!equations_.prepare_step(n())) return SolveStatus::step_too_large;
    const double ratio = n() == 1 ? 0.0 : grid().step(n()) / grid().step(n() - 1);
    if (n() == 1) f_before_ = f_;
    y_ = equations_.known() + equations_.kappa().cwiseProduct(f_ + ratio * (f_ - f_before_));
    const bool jump = jumps().correct(t(), y_, before_jump_, [&](double time) {
      for (int correction = 0; correction < options_.corrections; ++correction)
        y_ = equations_.known() + equations_.kappa().cwiseProduct(run_.rhs(time, y_));
    });
    result_ = jump ? &before_jump_ : &y_;
    return SolveStatus::finished;
  }

  void rule_state(Archive& archive) { archive(f_, equations_); }

 private:
  IntegratedEquations equations_;
  Vec before_jump_{}, f_, f_before_;
};

Trajectory predict_and_correct_equations(const Problem& problem, const Grid& grid, const Options& options) {
  const Problem stepped = integrated_problem(problem);
  return integrate(EquationPredictor(problem, stepped, grid, options));
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
