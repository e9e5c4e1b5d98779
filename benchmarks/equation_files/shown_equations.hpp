// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/benchmarks/equation_files/equation_text.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// Sets the equations of the factory to those of these unknowns: as sums of terms, or, where one is no such
// sum, all for display only.
void set_equations(const std::vector<UnknownText>& unknowns, SceneFactory& factory);

}  // namespace fde::bench
