// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// The problem from which the reference is computed, with the end of the scene.
PosedProblem reference_problem_of(const Scene& scene);

// The reference of the columns: scene.reference or, for a scene without one, a numerical reference whose
// bound is an estimate from two methods. Computing it takes some seconds, unless it is in the cache_folder().
// For a scene of an equation file, require_agreement is called. Throws std::runtime_error with the reason if
// there is no reference.
reference::Reference reference_of(const Scene& scene);

// The kind of evidence: "closed form", "inverse Laplace transform", "two methods" or "estimate".
std::string_view evidence_of(const Scene& scene);

}  // namespace fde::bench
