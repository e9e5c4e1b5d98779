#pragma once

#include <optional>

#include "diffusive/stages.hpp"
#include "march/rhs_noise.hpp"
#include "quadrature/radau.hpp"

namespace fde {

// What rounding leaves to be seen of the Legendre coefficients on a step. A march that took the noise below
// for an unresolved solution would halve its steps for ever.
class StageNoise {
 public:
  StageNoise(const Problem& problem, const RadauRule& rule) : rule_(rule), rhs_noise_(problem) {}

  // What coefficients are beyond their noise.
  [[nodiscard]] static Vec beyond(const Vec& coefficients, const Vec& noise);

  // Looks for noise of f that was not known of. Whether there is some on the step that explains why it is not
  // resolved. tolerated: the coefficients of f that the tolerance allows; scale: see RhsNoise::find.
  bool found_on(const StageSolution& stages, double from, double length, const Vec& tolerated, double scale);
  // The same where a step has no solution: on the step before it. size: of y so far.
  bool found_before(const Vec& size);

  // Takes note of a step.
  void follow(const StageSolution& stages, double length, double to);

  // Noise of f that is known, for StageEquations::allow_noise.
  [[nodiscard]] const Vec& of_rhs() const { return rhs_noise_.found(); }

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

}  // namespace fde
