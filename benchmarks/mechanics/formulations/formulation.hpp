#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scenes/parameters.hpp"

namespace fde::mechanics {

// Four forms of the same equations. They differ in what they do to the constraint: see docs/mechanics.md.
enum class Formulation {
  integrated,    // velocities from projected ones and the constraint: no singular term, no drift of its own
  acceleration,  // the constraint differentiated and solved for the multiplier (Tarasov & Zaslavsky 37)
  stabilised,    // the same with df/dt + kappa f = 0 (Baumgarte 1972)
  multiplier,    // the constraint as an algebraic row, the multiplier as an unknown
};

std::string name_of(Formulation formulation);

// Throws std::invalid_argument where no formulation has this name.
Formulation formulation_named(std::string_view name);

// All: they fit constraints that are affine in the velocity. The first is the default.
const std::vector<Formulation>& all_formulations();
// Those that fit any constraint: all but integrated.
const std::vector<Formulation>& unprojected_formulations();

// The parameters of a scene and behind them `formulation`, a choice from those that fit (the first is the
// default), and `kappa` where stabilised is among them.
std::vector<Parameter> with_formulations(std::vector<Parameter> parameters,
                                         const std::vector<Formulation>& fitting);

// How such parameters ask for the equations.
struct Asked {
  Formulation formulation = Formulation::integrated;
  double kappa = 0.0;  // not 0 for stabilised only
};
Asked asked_of(const Parameters& parameters);

}  // namespace fde::mechanics
