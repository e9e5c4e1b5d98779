#pragma once

#include <vector>

#include "scenes/variant.hpp"
#include "stepping/scheme.hpp"
#include "sweep/ladder.hpp"

namespace fde {

// All scenes, and some with orders that change the answer: a small one, one above 1, a solution that starts
// like a root, and pendulums whose commensurate expansion has many states.
std::vector<SceneVariant> default_scenes();

// What a sweep takes: the default scenes, and some mechanical ones in all formulations that are well posed
// for them. These share a solution and differ in what they do to the constraint.
std::vector<SceneVariant> sweep_scenes();

// The numbers of steps and the accuracies of a thorough sweep, and as many of these steps as answers need.
Ladder thorough_ladder();
Ladder default_ladder();

// Every scheme, and those that climb on the grid which the orders ask for as well, where solutions start
// singular.
std::vector<const Scheme*> sweep_schemes();
std::vector<const Scheme*> graded_schemes();

}  // namespace fde
