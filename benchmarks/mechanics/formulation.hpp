// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/scenes/parameters.hpp"

namespace fde::bench::mechanics {

// Four formulations of the same equations. They differ in the treatment of the constraint: see
// docs/mechanics.md.
enum class Formulation {
  integrated,    // velocities from projected ones and the constraint: no singular term, no own drift
  acceleration,  // the constraint differentiated and solved for the multiplier (Tarasov & Zaslavsky 37)
  stabilised,    // the same with df/dt + kappa f = 0 (Baumgarte 1972)
  multiplier,    // the constraint as an algebraic row, the multiplier as an unknown
};

std::string name_of(Formulation formulation);

// Throws std::invalid_argument if no formulation has this name.
Formulation formulation_named(std::string_view name);

// All formulations, for constraints that are affine in the velocity. The first is the default.
const std::vector<Formulation>& all_formulations();
// The formulations for any constraint: all except integrated.
const std::vector<Formulation>& unprojected_formulations();

// The parameters of a scene, followed by `formulation`, a choice from `fitting` (the first is the default),
// and, if stabilised is among them, `kappa`.
std::vector<Parameter> with_formulations(std::vector<Parameter> parameters,
                                         const std::vector<Formulation>& fitting);

// The formulation that such parameters select.
struct FormulationChoice {
  Formulation formulation = Formulation::integrated;
  double kappa = 0.0;  // nonzero for stabilised only
};
FormulationChoice formulation_choice_of(const Parameters& parameters);

}  // namespace fde::bench::mechanics
