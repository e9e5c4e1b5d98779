#pragma once

#include "equation_files/equation_text.hpp"
#include "scenes/registry.hpp"

namespace fde {

// The scene of an equation file; its id is the file's name.
SceneMaker equation_scene(EquationText text);

// These scenes, and those of equation files, each by the name of its file, which ends in .toml. A name throws
// std::invalid_argument where its file cannot be read or is no equation file.
Scenes with_equation_files(const Scenes& scenes);

}  // namespace fde
