#pragma once

#include <functional>
#include <utility>

#include "adaptive/adaptive_steps.hpp"
#include "implicit/step_equations.hpp"
#include "stepping/allowed_error.hpp"
#include "weights/step_factors.hpp"

namespace fde {

// How a step of the trapezoidal rule is solved.
class TrapezoidalSolver {
 public:
  TrapezoidalSolver() = default;
  TrapezoidalSolver(const TrapezoidalSolver&) = delete;
  TrapezoidalSolver& operator=(const TrapezoidalSolver&) = delete;
  virtual ~TrapezoidalSolver() = default;

  // y becomes the solution, from y at the step before, and f what joins the past there. False: there is none.
  // `continued` is f as the steps before continue it.
  virtual bool solve(Run& run, const StepEquations& step, const Vec& continued, Vec& y, Vec& f) = 0;

  // How far the solution is from that of the rule, as an error of f.
  [[nodiscard]] virtual Vec left_over() const = 0;

  // error becomes what the equations of the step make of it: (1 - kappa df/dy)^(-1) error, as far as it is
  // known.
  virtual void respond(Vec& error) const = 0;

  // What solves sparse equations; empty: there were none.
  [[nodiscard]] virtual std::string_view linear_solver() const { return {}; }

  // What it keeps from step to step.
  virtual void state(Archive& archive) = 0;
};

// Newton's method.
std::unique_ptr<TrapezoidalSolver> newton_on_trapezoids(const Problem& problem, double tolerance);
// f continued from the last step, then so many corrections: the Adams-Bashforth-Moulton pair of rate 2.
std::unique_ptr<TrapezoidalSolver> correct_predictions(int corrections);

// The product trapezoidal rule, y(t) = Taylor part + I^g of f as a line on each step, on steps of any length.
//
// The error of a step is that of the line against the parabola through f at the ends of the last two steps,
// a mean of h^2 f[t_(n-2), t_(n-1), t_n] / 6. Such errors have one sign as long as f bends to one side, and
// memory keeps them: one is worth h^g / Gamma(g+1) times it in y_n, but as large ones on all steps before a
// times that where nothing makes them decay, a = (t/h)^g, t since f jumped last, and of orders above 1 up to
// t end^(g-1) / h^g. What
// does so shows in the equations of the step: they leave a part r of an error when they answer to it a second
// time, with one row 1 / (1 - kappa df/dy), with more in the mean square of all rows or of those of one
// order. The first answer is what decays at once. Over all steps it is the answer times a / (r + a (1 - r)).
class TrapezoidalSteps final : public AdaptiveSteps {
 public:
  TrapezoidalSteps(const Problem& problem, const Accuracy& accuracy, const Options& options, Run& run,
                   double shortest, std::unique_ptr<TrapezoidalSolver> solver);

  double attempt(Run& run, double t) override;
  [[nodiscard]] double error_of_jump() const override;
  [[nodiscard]] const Vec& result() const override { return y_; }
  Vec between(double t) override;
  Vec continued(double t) override;
  void coast(Run& run, double t) override;
  void take() override;
  [[nodiscard]] Drives drives() const override;
  [[nodiscard]] const InterpolatedRows& interpolated() const override { return interpolated_; }
  void begin_anew(Run& run) override;
  [[nodiscard]] double rate() const override { return 2.0; }
  [[nodiscard]] std::size_t bytes() const override { return history_->bytes(); }
  [[nodiscard]] std::string_view linear_solver() const override { return solver_->linear_solver(); }
  void state(Archive& archive) override;

 private:
  // f at a time.
  struct Sample {
    double t;
    Vec f;
    void state(Archive& archive) { archive(t, f); }
  };
  void past_at(double t);
  [[nodiscard]] Vec continued_drive(double t) const;
  [[nodiscard]] Vec defect() const;
  static double largest_part(const Vec& error, const Vec& limit);
  [[nodiscard]] double error(const Vec& of_f);
  [[nodiscard]] Vec left_of(const Vec& answered, const Vec& again) const;
  [[nodiscard]] Vec effect() const;
  [[nodiscard]] std::pair<double, double> accumulation(double order) const;

  const Problem& problem_;
  TaylorPart taylor_;
  AllowedError allowed_;
  StepFactors factors_;
  std::unique_ptr<History> history_;
  std::unique_ptr<TrapezoidalSolver> solver_;
  Vec orders_;
  std::vector<Eigen::Index> group_{};  // of each row, the first of its order
  Sample newest_, next_;
  std::optional<Sample> older_{};
  double begun_ = 0.0;             // where f jumped last
  InterpolatedRows interpolated_;  // on the newest attempt
  Vec before_, y_, kappa_, convolved_, past_, limit_;
};

}  // namespace fde
