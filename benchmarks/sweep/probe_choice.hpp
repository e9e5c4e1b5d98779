// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "fdebench/benchmarks/scenes/variant.hpp"

namespace fde::bench {

// Which scenes are solved to forecast a sweep, and for each scene which of these stands for it.
struct ProbeChoice {
  std::vector<std::size_t> probed{};  // numbers of scenes
  std::vector<std::size_t> of{};      // for each scene an index of `probed`
};

// Chooses all variants of a scene, or at random most_probed_scenes of them, the same ones each time. For each
// other variant stands the nearest of these: distances are sums over the parameters, whose values count by
// their rank.
inline constexpr std::size_t most_probed_scenes = 48;
ProbeChoice choose_probes(const std::vector<SceneVariant>& scenes);

}  // namespace fde::bench
