#pragma once

#include <functional>
#include <memory>

#include "adaptive/adaptive_steps.hpp"
#include "stepping/scheme.hpp"

namespace fde {

// Creates the stepping rule of a run. `shortest` is a lower bound of all step sizes.
using MakeSteps = std::function<std::unique_ptr<AdaptiveSteps>(Run& run, double shortest)>;

// Solves a problem with adaptive step size. The right-hand side hardly changes on the first step (see
// first_length). A step ends at each time in Problem::jumps, and the rule restarts there.
Trajectory march_adaptively(const Problem& problem, const Accuracy& accuracy, const Options& options,
                            const MakeSteps& make);

}  // namespace fde
