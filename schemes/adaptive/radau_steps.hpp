#pragma once

#include <optional>

#include "adaptive/adaptive_steps.hpp"
#include "adaptive/stage_matrix.hpp"
#include "history/kernel_integrals.hpp"
#include "stepping/allowed_error.hpp"

namespace fde {

// Collocation at the three points of Radau IIA on steps of any length, orders up to 1:
//   y_i = past_i + sum_j K_ij f(t_j, y_j),   K the fractional integral of the parabola through f at the
// points, and past the integral over all steps before, whose exponentials are linear states that the step has
// eliminated. For order 1 it is the method of Hairer & Wanner (Solving ODEs II, section IV.8).
//
// The error of a step is estimated from how far the parabola is from f at the beginning of the step, and from
// what the equations of the step make of it. Beyond the newest steps memory sees of such errors their mean
// only, which is 0.
class RadauSteps final : public AdaptiveSteps {
 public:
  RadauSteps(const Problem& problem, const Accuracy& accuracy, const Options& options, Run& run,
             double shortest);

  double attempt(Run& run, double t) override;
  [[nodiscard]] const Vec& result() const override { return result_; }
  Vec between(double t) override;
  Vec continued(double t) override;
  void coast(Run& run, double t) override;
  void take() override;
  [[nodiscard]] Drives drives() const override { return parabolas_before_; }
  [[nodiscard]] const InterpolatedRows& interpolated() const override { return interpolated_; }
  void begin_anew(Run& run) override;
  [[nodiscard]] double rate() const override;
  [[nodiscard]] std::size_t bytes() const override;
  [[nodiscard]] std::string_view linear_solver() const override { return matrix_->solver(); }
  void state(Archive& archive) override;

 private:
  using Weights = Eigen::Matrix<double, stages, stages>;
  using Values = Eigen::Matrix<double, Eigen::Dynamic, stages>;  // one row a row, one column a stage

  // All rows of one order.
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
  void take_drives();
  [[nodiscard]] Values parabolas() const;
  Vec integrated(double t, const Values& polynomials);
  [[nodiscard]] double error();
  void interpolate(Eigen::Index row);
  [[nodiscard]] Vec limits() const;

  TaylorPart taylor_;
  AllowedError allowed_;
  std::vector<Kernel> kernels_;
  std::vector<std::optional<Row>> rows_;  // none of an algebraic row
  std::unique_ptr<StageMatrix> matrix_;
  StageWeights weights_;              // on the newest step
  double time_ = 0.0;                 // of the newest step taken
  double next_ = 0.0, length_ = 0.0;  // of the attempt
  std::optional<double> length_before_{};
  Values past_, y_, f_, drives_;   // drives: the derivatives D^g y, as f, but from the equations
  Values parabolas_before_;        // their parabolas on the step before, by powers of its share
  InterpolatedRows interpolated_;  // on the newest attempt
  Vec at_start_;                   // f where the step begins
  Vec before_, result_;
};

}  // namespace fde
