// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/benchmarks/records/default_accuracies.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/sweep/sweep_plan.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

// All scenes, and some again with other parameters that change the ranking of the schemes: a small order, an
// order above 1, a solution ~ t^0.7 near 0, pendulums whose commensurate expansion has many states.
std::vector<SceneVariant> default_scenes();

// The scenes of a sweep: default_scenes(), and some mechanical scenes in all formulations that are well
// posed. The formulations of a scene have the same solution and differ in the drift from the constraint.
std::vector<SceneVariant> sweep_scenes();

// The numbers of steps (64, 128, ..., 2^19) and tolerances (1e-2, ..., 1e-13) of a thorough sweep; and the
// search for the cheapest runs within each of default_accuracies, at the end time and over all times.
SweepPlan thorough_plan();
SweepPlan default_plan();

// Every scheme; and the schemes that also run on the grid of optimal_grading() where solutions are not smooth
// at 0.
std::vector<const Scheme*> sweep_schemes();
std::vector<const Scheme*> graded_schemes();

}  // namespace fde::bench
