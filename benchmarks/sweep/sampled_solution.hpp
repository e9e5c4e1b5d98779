// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/records/scene_description.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// The reference solution at the times that a chart needs, dense where a column is curved: at most 400 times
// and the first eight columns, values to four digits. Throws std::runtime_error if the reference is not
// finite at one of the times.
SampledSolution sample_solution(const Scene& scene, const reference::Reference& reference);

}  // namespace fde::bench
