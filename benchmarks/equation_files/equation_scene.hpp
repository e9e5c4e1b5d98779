// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/equation_files/equation_text.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"

namespace fde::bench {

// The scene of an equation file; its id is the file name.
SceneFactory equation_scene(EquationText text);

// These scenes plus those of equation files, found by a file name that ends in .toml. For such a name,
// SceneRegistry::named throws std::invalid_argument if the file cannot be read or is not an equation file.
SceneRegistry with_equation_files(const SceneRegistry& scenes);

}  // namespace fde::bench
