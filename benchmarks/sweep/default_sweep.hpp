#pragma once

#include <vector>

#include "scenes/variant.hpp"
#include "stepping/scheme.hpp"

namespace fde {

// All scenes, and some with orders that change the answer: a small one, one above 1, a solution that starts
// like a root, and pendulums whose commensurate expansion has many states.
std::vector<SceneVariant> default_scenes();

// What a sweep takes: the default scenes, and some mechanical ones in all formulations that are well posed
// for them. These share a solution and differ in what they do to the constraint.
std::vector<SceneVariant> sweep_scenes();

// The default numbers of steps of a sweep, increasing.
std::vector<int> sweep_steps();

// Every scheme.
std::vector<const Scheme*> sweep_schemes();

}  // namespace fde
