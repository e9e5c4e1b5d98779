// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fdebench/benchmarks/scenes/registry.hpp"

namespace fde::bench {

// Runs the command with these arguments and returns its standard output. Throws std::invalid_argument (exit
// code 2) or NumericalFailure (any other but 0) with the last line of its standard error.
std::string output_of(const std::vector<std::string>& arguments,
                      const SceneRegistry& known = built_in_scenes());

// Removes the dashes of options in a message, "--steps = 0: must be ...": in a language they are arguments.
std::string without_dashes(std::string text);

}  // namespace fde::bench
