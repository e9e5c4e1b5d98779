// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/history/kernel_integrals.hpp"
#include "fdebench/schemes/history/weights/weights.hpp"

namespace fde {

// Direct summation on variable steps: fractional integrals of piecewise linear functions
// (kernel_moments.hpp), scaled so that the new sample has weight 1. On equal steps these are the sums of
// DirectHistory. All weights are recomputed for every candidate time, O(n) powers at step n.
class VariableStepDirectHistory final : public History {
 public:
  VariableStepDirectHistory(const WeightTables& tables, const StepPlan& steps);
  [[nodiscard]] std::unique_ptr<History> copy() const override {
    return std::make_unique<VariableStepDirectHistory>(*this);
  }
  void push(double t, In sample) override;
  void convolve(double t, std::size_t sum, Out result) const override;
  [[nodiscard]] std::size_t bytes() const override;
  void state(Archive& archive) override;

 private:
  // The weights of all steps up to the candidate time, for one order of integration.
  struct Integral {
    double order;
    Vec left, right;
  };
  // The quantities of the last candidate time, cached.
  struct StepCache {
    std::optional<double> time{};
    std::vector<Integral> integrals{};
  };
  // One component in one sum.
  struct ComponentSum {
    Eigen::Index component;
    WeightTable table;
    std::size_t integral;
  };
  void reserve(Eigen::Index steps);
  // The end of the step from sample j; t for the candidate step.
  [[nodiscard]] double end_of_step(std::size_t j, double t) const;
  [[nodiscard]] const StepCache& candidate(double t) const;

  std::vector<double> times_;                      // of the samples
  Matrix samples_;                                 // one row a time, then rows of zeros
  std::vector<std::vector<ComponentSum>> tracks_;  // of each sum; only components with a memory term
  mutable StepCache candidate_;
};

// The sums of VariableStepDirectHistory with the kernel as a sum of exponentials: O(1) work a step and
// constant memory. For orders g > 1 the running integral of the function is integrated with the order g - 1.
class VariableStepExponentialHistory final : public History {
 public:
  VariableStepExponentialHistory(const WeightTables& tables, const StepPlan& steps, double tolerance);
  [[nodiscard]] std::unique_ptr<History> copy() const override {
    return std::make_unique<VariableStepExponentialHistory>(*this);
  }
  void push(double t, In sample) override;
  void convolve(double t, std::size_t sum, Out result) const override;
  [[nodiscard]] std::size_t bytes() const override;
  void state(Archive& archive) override;

 private:
  // One component in one sum.
  struct ComponentSum {
    Eigen::Index component;
    std::size_t table, kernel;
    Eigen::Index function;    // index in its KernelIntegrals
    bool running_sums;        // the order is above 1
    RunningSums integral{1};  // of the function, for orders above 1
  };
  // The quantities of the last candidate time, cached.
  struct StepCache {
    std::optional<double> time{};
    std::vector<KernelStep> steps{};  // of each kernel
    Vec to_sums{};                    // integral_to_sum_factor of each table
  };
  std::size_t kernel_of(const WeightTable& table, const StepPlan& steps, double tolerance);
  [[nodiscard]] Polynomial integrand(const ComponentSum& track, double before, double after,
                                     double length) const;
  [[nodiscard]] const StepCache& candidate(double t) const;
  void advance(double t, In sample);

  std::vector<WeightTable> tables_;       // each once
  mutable StepFactors factors_{tables_};  // of tables_
  std::vector<KernelIntegrals> kernels_;
  std::vector<std::vector<ComponentSum>> tracks_;  // of each sum; only components with a memory term
  double time_ = 0.0;                              // of the newest sample
  Vec newest_;
  mutable StepCache candidate_;
};

}  // namespace fde
