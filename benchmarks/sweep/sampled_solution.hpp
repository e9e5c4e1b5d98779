// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "fdebench/benchmarks/records/scene_description.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// At most this many times, and the first columns; a diffusion has hundreds.
struct SampleLimits {
  std::ptrdiff_t times = 1200;
  Eigen::Index columns = 8;
};

// The reference solution at the times that a chart needs, values to four digits: times are added where the
// polyline through the others is farthest off, until it is within 0.4 % of each column's range everywhere or
// there are as many as allowed. Throws std::runtime_error if the reference is not finite at one of the times.
SampledSolution sample_solution(const Scene& scene, const reference::Reference& reference,
                                const SampleLimits& limits = {});

}  // namespace fde::bench
