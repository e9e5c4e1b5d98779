#pragma once

#include "history/history.hpp"

namespace fde {

// The past on steps that differ: fractional integrals of piecewise linear functions (interval_weights.hpp),
// in units in which the newest sample has weight 1. On equal steps these are the sums of DirectHistory. Every
// candidate weighs every earlier step anew, O(n) powers at step n.
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
  // The weights of all steps up to the candidate, for one order of integration.
  struct Integral {
    double order;
    Vec left, right;
  };
  // What the last candidate needed.
  struct Candidate {
    std::optional<double> time{};
    std::vector<Integral> integrals{};
  };
  // One component in one sum.
  struct Track {
    Eigen::Index component;
    WeightTable table;
    std::size_t integral;
  };
  void reserve(Eigen::Index steps);
  // Of the step from sample j on, where the candidate ends at t.
  [[nodiscard]] double end_of_step(std::size_t j, double t) const;
  [[nodiscard]] const Candidate& candidate(double t) const;

  std::vector<double> times_;               // of the samples
  Matrix samples_;                          // one row a time, and rows of zeros
  std::vector<std::vector<Track>> tracks_;  // of each sum; without those that have no past
  mutable Candidate candidate_;
};

}  // namespace fde
