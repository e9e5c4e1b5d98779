// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// The zeros of the characteristic function of a scene (Reference::zeros): those that its reference knows, or
// else those of det(diag(s^g) - A) with A the linear part of its problem, whatever its loads. nullopt where
// it has neither: for nonlinear and for time-dependent f, delays, events that set unknowns, more than 12
// rows. Throws std::runtime_error where not all zeros are found.
std::optional<std::vector<reference::CharacteristicZero>> poles_of(const Scene& scene);

}  // namespace fde::bench
