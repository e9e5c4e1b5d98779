// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "fdebench/reference/nonlinear/march/implicit_step.hpp"
#include "fdebench/reference/nonlinear/march/rhs_noise.hpp"
#include "fdebench/reference/nonlinear/quadrature/gauss.hpp"

namespace fde::reference {

// y and f at the stages of a step, one row per stage, and their rounding noise.
struct StageSolution {
  Matrix y, rhs;
  Noise noise;
};

// The equations y_i = history_i + weights_i f_i(t, y) at the stages of a Runge-Kutta step (history: the
// history term), and 0 = f_i(t, y) in algebraic rows, where history is an initial guess.
class StageEquations {
 public:
  StageEquations(const Problem& problem, Vec nodes);

  // Newton's method down to rounding. The initial guess has f = last_rhs at all stages or, where f depends on
  // y so strongly that this is far from y, the last value. The first step, and one after a jump, follow the
  // root that continues the solution. size: the largest |y| so far. nullopt where it does not converge.
  [[nodiscard]] std::optional<StageSolution> solve(const Matrix& history, const std::vector<Matrix>& weights,
                                                   double from, double length, In last_value, In last_rhs,
                                                   In size) const;

  // Sets the rounding noise of f that neither its size nor its derivatives show.
  void set_rhs_noise(const Vec& rhs_noise) { rhs_noise_ = rhs_noise; }
  [[nodiscard]] const Vec& nodes() const { return nodes_; }

 private:
  [[nodiscard]] std::optional<StageSolution> newton(const Matrix& history, const std::vector<Matrix>& weights,
                                                    const Vec& times, const Matrix& guess, In size) const;
  // Linearises at at.y, and sets at.noise.
  [[nodiscard]] LinearisedStep linearise(const Vec& times, const std::vector<Matrix>& weights,
                                         StageSolution& at) const;

  const Problem& problem_;
  Vec nodes_;
  Vec forcing_;  // the largest |f| at the initial values over all times: 1 - cos t is mostly rounding near 0
  Vec rhs_noise_ = Vec::Zero(problem_.size());
};

// The rounding noise of the Legendre coefficients on a step. Without it, noise would count as an unresolved
// solution, and steps would be halved without end.
class StageNoise {
 public:
  StageNoise(const Problem& problem, const RadauRule& rule) : rule_(rule), rhs_noise_(problem) {}

  // The coefficients minus an allowance for their noise.
  [[nodiscard]] static Vec above_noise(const Vec& coefficients, const Vec& noise);

  // Whether there is new noise of f on the step that explains why the step does not resolve the solution.
  // tolerated: the coefficients of f that the tolerance allows; scale: see RhsNoise::detect.
  bool detect(const StageSolution& stages, double from, double length, const Vec& tolerated, double scale);
  // The same for a step without a solution, from the step before it. size: of y so far.
  bool detect_on_last_step(const Vec& size);

  // Records an accepted step of size `length` that ends at `to`.
  void record_accepted_step(const StageSolution& stages, double length, double to);

  // The noise of f found so far, for StageEquations::set_rhs_noise.
  [[nodiscard]] const Vec& known_rhs_noise() const { return rhs_noise_.allowance(); }

 private:
  struct Step {
    StageSolution stages;
    double length, to;
  };
  [[nodiscard]] Vec times(const Step& step) const;

  const RadauRule& rule_;
  RhsNoise rhs_noise_;
  std::optional<Step> last_;
};

}  // namespace fde::reference
