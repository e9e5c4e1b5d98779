// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "fdebench/reference/nonlinear/diffusive/stages.hpp"
#include "fdebench/reference/nonlinear/march/rhs_noise.hpp"
#include "fdebench/reference/nonlinear/quadrature/radau.hpp"

namespace fde::reference {

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
