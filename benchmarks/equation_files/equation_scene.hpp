// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_text.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"

namespace fde::bench {

// Gets lines about what a scene changes of its file.
using NoteReceiver = std::function<void(const std::string& note)>;

// The scene of an equation file; its id is the file name.
SceneFactory equation_scene(EquationText text, const NoteReceiver& on_note = {});

// The scene of an equation file that is built into the program: its reference is not compared with schemes,
// and it has no checksum.
SceneFactory built_in_scene(const std::string& id, std::string_view toml);

// These scenes plus those of equation files, found by a file name that ends in .toml, or by the name without
// .toml of a file in the folder $FDEBENCH_SCENES. For such a name, SceneRegistry::named throws
// std::invalid_argument if the file cannot be read or is not an equation file. Throws std::invalid_argument
// if a file of that folder has the name of one of `scenes`. `on_note` is called, in any thread, each time
// that such a scene is made.
SceneRegistry with_equation_files(const SceneRegistry& scenes, NoteReceiver on_note = {});

// The names, sorted and without .toml, of the equation files in the folder $FDEBENCH_SCENES.
std::vector<std::string> names_in_scene_folder();

}  // namespace fde::bench
