// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "fdebench/schemes/history/kernel_integrals.hpp"
#include "fdebench/schemes/rules/adaptive/adaptive_rule.hpp"
#include "fdebench/schemes/rules/adaptive/stage_matrix.hpp"
#include "fdebench/schemes/stepping/error_tolerance.hpp"

namespace fde {

// Collocation at the three points of Radau IIA with adaptive step size, orders up to 1:
//   y_i = known_i + sum_j K_ij f(t_j, y_j),   i, j = 1, 2, 3.
// K gives the fractional integral of the parabola through f at the points. known is the Taylor part and the
// integral over all steps before, by a sum of exponentials, whose (linear) states are eliminated from the
// equations of the step. For order 1 it is the method of Hairer & Wanner (Solving ODEs II, section IV.8).
//
// The error of a step is estimated from the distance of the parabola from f at the beginning of the step: a
// constant times this defect, multiplied by the inverse of the iteration matrix. Beyond the newest steps only
// the mean of such an error over its step matters for the memory term, and the mean is 0.
class RadauRule final : public AdaptiveRule {
 public:
  // shortest: a lower bound of all step sizes. The problem must outlive this object.
  RadauRule(const Problem& problem, const Tolerance& accuracy, const Options& options, Run& run,
            double shortest);

  double attempt(Run& run, double t) override;
  [[nodiscard]] const Vec& result() const override { return result_; }
  Vec dense_output(double t) override;
  Vec extrapolate(double t) override;
  void extrapolate_over_jump(double t) override;
  void accept() override;
  [[nodiscard]] DerivativePolynomials derivative_polynomials() const override { return previous_parabolas_; }
  [[nodiscard]] const InterpolatedRows& interpolated_rows() const override { return interpolated_; }
  [[nodiscard]] const Matrix& slopes_left_out() const override { return previous_slopes_; }
  void restart(Run& run) override;
  [[nodiscard]] double rate() const override;
  [[nodiscard]] std::size_t bytes() const override;
  [[nodiscard]] std::string_view linear_solver() const override { return matrix_->solver(); }
  void state(Archive& archive) override;

 private:
  using Weights = Eigen::Matrix<double, stages, stages>;
  using Values = Eigen::Matrix<double, Eigen::Dynamic, stages>;  // one row a component, one column a stage

  // All components of one order.
  struct Kernel {
    double order;
    KernelIntegrals integrals;
    Weights weights, inverse;  // for steps of length 1
    std::array<KernelStep, stages> to_stage{};
    double unit = 1.0;  // length^order
  };
  struct Row {
    std::size_t kernel;
    Eigen::Index function;
  };
  void prepare(double t);
  void guess();
  bool solve(Run& run);
  [[nodiscard]] Vec residual() const;
  bool evaluate(Run& run);
  void compute_derivatives();
  void compute_slopes(Run& run);
  [[nodiscard]] Values parabolas() const;
  Vec integrated(double t, const Values& polynomials, const Matrix& slopes);
  [[nodiscard]] double error(Run& run);
  void measure_rhs_error(Run& run);
  [[nodiscard]] bool is_rounding(Run& run, const Vec& increment);
  [[nodiscard]] Values effect_of(const Vec& defects) const;
  [[nodiscard]] Vec answer_to(const Values& effect) const;
  void interpolate(Eigen::Index row);
  [[nodiscard]] Vec limits() const override;
  [[nodiscard]] Vec limits_of_rows() const;

  const Problem& problem_;
  TaylorPart taylor_;
  ErrorTolerance allowed_;
  std::vector<Kernel> kernels_;
  std::vector<std::optional<Row>> rows_;  // empty: an algebraic row
  bool has_algebraic_rows_ = false;
  std::unique_ptr<StageMatrix> matrix_;
  StageWeights weights_;         // of the attempt
  double time_ = 0.0;            // end of the last accepted step
  double last_jump_time_ = 0.0;  // time of the last jump of f
  std::int64_t steps_since_jump_ = 0;
  double next_ = 0.0, length_ = 0.0;  // end and size of the attempt
  std::optional<double> previous_length_{};
  // derivatives_: D^g y from the equations of the step, in place of f(t, y).
  Values known_, y_, f_, derivatives_;
  Values previous_parabolas_;        // coefficients of their parabolas on the last accepted step
  InterpolatedRows interpolated_;    // on the newest attempt
  Matrix slopes_, previous_slopes_;  // left out of the parabolas on the newest attempt, and on the last step
  RhsError rhs_error_;               // measured where the error test or Newton's method failed last
  Vec derivatives_at_start_;         // f at the beginning of the step
  Vec previous_, result_;
};

}  // namespace fde
