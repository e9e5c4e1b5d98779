#pragma once

#include <optional>
#include <vector>

#include "problem/problem.hpp"

namespace fde {

// y and f at the stages of a step, a row a stage; how much of them rounding explains.
struct StageSolution {
  Matrix y, rhs;
  Vec y_noise, rhs_noise;
};

// The equations y_i = past_i + weights_i f_i(t, y) at the stages of a Runge-Kutta step.
class StageEquations {
 public:
  StageEquations(const Problem& problem, Vec nodes);

  // Newton's method down to rounding, from f = first_rhs at all stages; size: how large y has been so far.
  // Empty where it does not converge.
  [[nodiscard]] std::optional<StageSolution> solve(const Matrix& past, const std::vector<Matrix>& weights,
                                                   double from, double length, In first_rhs, In size) const;

  // Rounding of f that neither its size nor its derivatives tell of.
  void allow_noise(const Vec& rhs_noise) { rhs_noise_ = rhs_noise; }
  [[nodiscard]] const Vec& nodes() const { return nodes_; }

 private:
  [[nodiscard]] Matrix rhs_at(const Vec& times, const Matrix& y) const;
  [[nodiscard]] Matrix jacobian_at(double t, const Vec& y) const;
  [[nodiscard]] std::vector<Matrix> jacobians_at(const Vec& times, const Matrix& y) const;

  const Problem& problem_;
  Vec nodes_;
  Vec forcing_;  // the largest f at the initial values at any time: 1 - cos t is all rounding near 0
  Vec rhs_noise_ = Vec::Zero(problem_.size());
};

}  // namespace fde
