// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/records/scene_description.hpp"
#include "fdebench/benchmarks/references/memoized_reference.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"

namespace fde::bench {

// What results files say of a scene, on request with its solution, if there is a reference. `scene` is made
// from the variant, and `reference` is of the scene.
SceneDescription describe(const SceneVariant& variant, const Scene& scene, MemoizedReference& reference,
                          bool with_solution = true);

}  // namespace fde::bench
