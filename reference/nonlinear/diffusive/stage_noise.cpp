// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/diffusive/stage_noise.hpp"

#include <limits>

namespace fde::reference {

namespace {

constexpr double known_rounding = 64.0;  // in units of the noise already known
constexpr double noises = 4.0;           // the sum of some rounding errors

}  // namespace

Vec StageNoise::above_noise(const Vec& coefficients, const Vec& noise) {
  return coefficients - noises * noise;
}

bool StageNoise::detect(const StageSolution& stages, double from, double length, const Vec& tolerated,
                        double scale) {
  const Vec unresolved = (rule_.at_nodes.bottomRows(2) * stages.rhs).cwiseAbs().colwise().maxCoeff();
  const Vec negligible = known_rounding * stages.noise.rhs + tolerated;
  return rhs_noise_.detect(from + length * rule_.nodes.cast<double>().array(), stages.y, unresolved,
                           negligible, scale);
}

bool StageNoise::detect_on_last_step(const Vec& size) {
  if (!last_) {
    return false;
  }
  const Vec rhs_size = last_->stages.rhs.cwiseAbs().colwise().maxCoeff();
  const Vec negligible = known_rounding * last_->stages.noise.rhs;
  const Vec unresolved = negligible.cwiseMax(std::numeric_limits<double>::min());
  return rhs_noise_.detect(times(*last_), last_->stages.y, unresolved, negligible,
                           size.cwiseMax(rhs_size).maxCoeff());
}

void StageNoise::record_accepted_step(const StageSolution& stages, double length, double to) {
  last_ = {stages, length, to};
  const Vec explained = noises * (stages.noise.rhs - rhs_noise_.allowance());
  rhs_noise_.update_after_step(times(*last_), stages.y, explained);
}

// Computed from the end of the step, where the next step starts.
Vec StageNoise::times(const Step& step) const {
  return step.to + step.length * (rule_.nodes.cast<double>().array() - 1.0);
}

}  // namespace fde::reference
