#pragma once

#include <optional>
#include <vector>

#include "march/implicit_step.hpp"

namespace fde {

// y and f at the stages of a step, a row a stage; how much of them rounding explains.
struct StageSolution {
  Matrix y, rhs;
  Noise noise;
};

// The equations y_i = past_i + weights_i f_i(t, y) at the stages of a Runge-Kutta step, and 0 = f_i(t, y) in
// algebraic rows, where past is a first guess.
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
  // Linearises at the y of a solution, and says how much of it is noise.
  [[nodiscard]] LinearisedStep linearise(const Vec& times, const std::vector<Matrix>& weights,
                                         StageSolution& at) const;
  [[nodiscard]] Matrix jacobian_at(double t, const Vec& y) const;

  const Problem& problem_;
  Vec nodes_;
  Vec forcing_;  // the largest f at the initial values at any time: 1 - cos t is all rounding near 0
  Vec rhs_noise_ = Vec::Zero(problem_.size());
};

}  // namespace fde
