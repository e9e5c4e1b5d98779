#pragma once

#include <functional>
#include <memory>

#include "adaptive/adaptive_steps.hpp"
#include "stepping/scheme.hpp"

namespace fde {

// Makes the rule for a problem whose steps will not be shorter than this.
using MakeSteps = std::function<std::unique_ptr<AdaptiveSteps>(Run& run, double shortest)>;

// Solves a problem by steps that find their lengths. The first is so short that the right-hand side hardly
// changes on it; a jump is the end of a step, and what follows begins anew.
Trajectory march_adaptively(const Problem& problem, const Accuracy& accuracy, const Options& options,
                            const MakeSteps& make);

}  // namespace fde
