// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <utility>

#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/rules/adaptive/adaptive_rule.hpp"
#include "fdebench/schemes/rules/implicit/step_equations.hpp"
#include "fdebench/schemes/stepping/error_tolerance.hpp"

namespace fde {

// Solver of the equations of one step of the trapezoidal rule.
class TrapezoidalSolver {
 public:
  TrapezoidalSolver& operator=(TrapezoidalSolver&&) = delete;
  virtual ~TrapezoidalSolver() = default;

  // On entry y is the solution at the previous step; on exit it is the solution of the step, and f is the
  // value for the history. `continued` is f extrapolated from the previous steps. Returns false if there is
  // no solution.
  virtual bool solve(Run& run, const StepEquations& step, const Vec& continued, Vec& y, Vec& f) = 0;

  // The error of the last solve against the exact solution of the step equations, as an error of f.
  [[nodiscard]] virtual Vec iteration_error() const = 0;

  // Replaces error by (1 - kappa df/dy)^(-1) error; a solver without a Jacobian leaves it unchanged.
  virtual void apply_inverse(Vec& error) const = 0;

  // The method that solved sparse equations; empty: there were none.
  [[nodiscard]] virtual std::string_view linear_solver() const { return {}; }

  // Saves or restores the state between two steps.
  virtual void state(Archive& archive) = 0;
};

// Newton's method (see NewtonSolver). The problem must outlive the solver.
std::unique_ptr<TrapezoidalSolver> make_newton_solver(const Problem& problem, double tolerance);
// f extrapolated, then so many corrections: the Adams-Bashforth-Moulton pair of rate 2.
std::unique_ptr<TrapezoidalSolver> make_predictor_corrector(int corrections);

// The product trapezoidal rule with adaptive step size: y(t) = Taylor part + I^g f with f linear on each
// step.
//
// The error of f on a step is the mean distance of the line from the parabola through f at the ends of the
// last two steps, h^2 f[t_(n-2), t_(n-1), t_n] / 6. These errors keep their sign while the second derivative
// of f keeps its sign, and they accumulate in the memory term: an error e on one step contributes e h^g /
// Gamma(g+1) to y_n, equal errors on all steps contribute a times that if they do not decay. Here a =
// (t/h)^g, t the time since the last jump of f, and for orders above 1 up to t end^(g-1) / h^g.
//
// Their decay is estimated from the equations of the step: (1 - kappa df/dy)^(-1) is applied to the error
// twice. The first result is the error of one step. The second application leaves the part r of it: for one
// component r = 1 / (1 - kappa df/dy), otherwise a ratio of root mean squares over all components or over
// those of one order. The error over all steps is the first result times a / (r + a (1 - r)).
class TrapezoidalRule final : public AdaptiveRule {
 public:
  // shortest: a lower bound of all step sizes. The problem must outlive this object.
  TrapezoidalRule(const Problem& problem, const Tolerance& accuracy, const Options& options, Run& run,
                  double shortest, std::unique_ptr<TrapezoidalSolver> solver);

  double attempt(Run& run, double t) override;
  [[nodiscard]] double error_of_jump() const override;
  [[nodiscard]] const Vec& result() const override { return y_; }
  [[nodiscard]] Vec limits() const override { return limit_; }
  Vec dense_output(double t) override;
  Vec extrapolate(double t) override;
  void extrapolate_over_jump(double t) override;
  void evaluate_behind_jump(Run& run) override;
  void accept() override;
  [[nodiscard]] DerivativePolynomials derivative_polynomials() const override;
  [[nodiscard]] const InterpolatedRows& interpolated_rows() const override { return interpolated_; }
  void restart(Run& run) override;
  [[nodiscard]] double rate() const override { return 2.0; }
  [[nodiscard]] std::size_t bytes() const override { return history_->bytes(); }
  [[nodiscard]] std::string_view linear_solver() const override { return solver_->linear_solver(); }
  void state(Archive& archive) override;

 private:
  // f at the time t.
  struct Sample {
    double t;
    Vec f;
    void state(Archive& archive) { archive(t, f); }
  };
  void compute_known(double t);
  [[nodiscard]] Vec extrapolated_rhs(double t) const;
  [[nodiscard]] Vec defect() const;
  static double weighted_max_norm(const Vec& error, const Vec& limit);
  [[nodiscard]] double error(Run& run, const Vec& of_f);
  [[nodiscard]] Vec undamped_fraction(const Vec& answered, const Vec& again) const;
  [[nodiscard]] Vec effect_of_rhs_error() const;
  [[nodiscard]] std::pair<double, double> accumulation(double order) const;

  const Problem& problem_;
  TaylorPart taylor_;
  ErrorTolerance allowed_;
  StepFactors factors_;
  std::unique_ptr<History> history_;
  std::unique_ptr<TrapezoidalSolver> solver_;
  Vec orders_;
  std::vector<Eigen::Index> first_of_same_order_{};  // for each component, the first of the same order
  Sample newest_, next_;
  std::optional<Sample> older_{};
  RhsError rhs_error_;             // measured where the error test failed last
  double last_jump_time_ = 0.0;    // time of the last jump of f
  InterpolatedRows interpolated_;  // on the newest attempt
  Vec previous_, y_, kappa_, convolved_, known_, limit_;
};

}  // namespace fde
