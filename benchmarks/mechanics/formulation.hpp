#pragma once

#include <vector>

#include "parameters.hpp"

namespace fde::mechanics {

// Four forms of the same equations. They differ in what they do to the constraint: see docs/the_mechanics.md.
enum class Formulation {
  integrated,    // velocities from projected ones and the constraint: no singular term, no drift of its own
  acceleration,  // the constraint differentiated and solved for the multiplier (Tarasov & Zaslavsky 37)
  stabilised,    // the same with df/dt + kappa f = 0 (Baumgarte 1972)
  multiplier,    // the constraint as an algebraic row, the multiplier as an unknown
};

// The parameters `formulation`, from those that fit a scene (the first is the default), and `kappa` where
// stabilised is among them.
std::vector<Parameter> formulation_parameters(const std::vector<Formulation>& fitting);
// Behind those of a scene.
std::vector<Parameter> with_formulations(std::vector<Parameter> parameters,
                                         const std::vector<Formulation>& fitting);
// All: they fit constraints that are affine in the velocity.
const std::vector<Formulation>& all_formulations();
Formulation formulation_of(const Parameters& parameters, const std::vector<Formulation>& fitting);

}  // namespace fde::mechanics
