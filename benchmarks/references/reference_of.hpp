// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// The problem from which the reference is computed, with the end of the scene.
PosedProblem reference_problem_of(const Scene& scene);

// The reference of the columns: scene.reference or, for a scene without one, a numerical reference whose
// bound is an estimate from two methods. Computing it takes some seconds, unless it is in the cache_folder().
// For a scene of an equation file with a closed form or a transform, require_agreement is called. Throws
// std::runtime_error with the reason if there is no reference.
reference::Reference reference_of(const Scene& scene);

// Whether the reference is computed by two methods for a right-hand side that is no formula: interval
// arithmetic does not show then that its residual is small between the points at which it is examined.
bool is_examined_at_points_only(const Scene& scene);

// The kind of evidence: "closed form", "inverse Laplace transform", "two methods", "two methods,
// examined at points only" where the right-hand side is no formula, or "estimate".
std::string_view evidence_of(const Scene& scene);

// Compares a reference at three times with two schemes that share no code with it, radau_exponentials and
// spectral_collocation, with a tolerance of 1e-5 of the solution. Throws std::runtime_error naming the
// column, the time and the three values if the schemes agree with each other to a thousandth of the solution
// and the reference differs by more than a hundredth. There is no check if one of them refuses the problem or
// does not finish within two seconds.
void require_agreement(const Scene& scene, const reference::Reference& reference);

}  // namespace fde::bench
