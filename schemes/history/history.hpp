// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "fdebench/schemes/history/history_kind.hpp"
#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/problem/grid.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

class Archive;

// The history of one run: stores samples x_0, x_1, ... (one value a component) and evaluates the memory
// terms, discrete convolutions of the samples. Several sums share the samples: predictor and corrector apply
// different weights to the same f.
class History {
 public:
  History() = default;
  History& operator=(const History&) = delete;
  virtual ~History() = default;

  // A deep copy, with the samples pushed so far. Copying an empty history is cheaper than make_history.
  [[nodiscard]] virtual std::unique_ptr<History> copy() const = 0;

  // Appends the sample at time t, size components; t must increase. With equal steps t is ignored, because
  // the number of samples determines the time; the same holds for convolve.
  virtual void push(double t, In sample) = 0;

  // The memory term of a step from the newest sample to time t: for every component i, after n >= 1 samples,
  //   result_i = first_sample_weight_i(n) x_{0,i} + sum_{1<=j<n} w_i(n-j) x_{j,i}
  // with the weights of tables[sum][i] of make_history. With variable steps the weights are integrals over
  // the steps, scaled so that the new sample at t has weight 1. The call does not change the history, so a
  // step can be rejected. Not thread-safe: the quantities of the last t are cached.
  virtual void convolve(double t, std::size_t sum, Out result) const = 0;

  [[nodiscard]] ChosenHistory chosen() const { return chosen_; }
  void set_chosen(ChosenHistory chosen) { chosen_ = chosen; }  // by make_history

  // Memory for samples and weights, in bytes.
  [[nodiscard]] virtual std::size_t bytes() const = 0;

  // Archives the part of the state that depends on the samples.
  virtual void state(Archive& archive) = 0;

 protected:
  History(const History&) = default;

 private:
  ChosenHistory chosen_{};
};

// tables[sum][i] is the weight table of component i in that sum.
using WeightTables = std::vector<std::vector<WeightTable>>;

// The step sizes for which a history is made. The first step starts at time 0.
struct StepPlan {
  double end = 1.0;                 // upper bound of the time of the last step
  double min_step = 1.0;            // lower bound of the step size, up to rounding
  bool uniform = false;             // all steps have the size `min_step`
  std::optional<int> step_count{};  // the number of steps; nullopt: unknown

  // The number of steps, or an upper bound where it is unknown.
  [[nodiscard]] int max_steps() const;
};
StepPlan step_plan(const Grid& grid);

// The kind that a run uses: for `automatic` the one whose time and memory history_costs estimates to be
// smaller (HistoryCost::time_and_memory), `direct` for families without a sum of exponentials; otherwise
// `kind`.
ChosenHistory choose_history(HistoryKind kind, const WeightTables& tables, const StepPlan& steps,
                             double tolerance);

// Makes an empty history. `tolerance` bounds the relative error of each weight and is clamped to
// [1e-16, 0.1]; `direct` uses exact weights. Throws std::invalid_argument naming the family where it has no
// sum of exponentials or no weights for variable steps.
std::unique_ptr<History> make_history(HistoryKind kind, const WeightTables& tables, const StepPlan& steps,
                                      double tolerance);

// Compensated running sums (Neumaier), one a component.
class RunningSums {
 public:
  explicit RunningSums(Eigen::Index size) : total_(Vec::Zero(size)), carry_(Vec::Zero(size)) {}

  void add(Eigen::Index i, double value) {
    const double old = total_[i];
    total_[i] = old + value;
    carry_[i] += std::abs(old) >= std::abs(value) ? (old - total_[i]) + value : (value - total_[i]) + old;
  }
  void add(In values) {
    for (Eigen::Index i = 0; i < values.size(); ++i) add(i, values[i]);
  }
  [[nodiscard]] double operator[](Eigen::Index i) const { return total_[i] + carry_[i]; }
  [[nodiscard]] Eigen::Index size() const { return total_.size(); }
  void state(Archive& archive) { archive(total_, carry_); }

 private:
  Vec total_, carry_;
};

}  // namespace fde
