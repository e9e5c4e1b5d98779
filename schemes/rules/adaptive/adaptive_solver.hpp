// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include "fdebench/schemes/rules/adaptive/adaptive_rule.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

// Creates the stepping rule of a run. `shortest` is a lower bound of all step sizes.
using AdaptiveRuleFactory = std::function<std::unique_ptr<AdaptiveRule>(Run& run, double shortest)>;

// Solves a problem with adaptive step size. The right-hand side hardly changes on the first step (see
// initial_step_size). A step ends at each of the breaking_points, and the rule restarts there.
Trajectory solve_adaptively(const Problem& problem, const Tolerance& accuracy, const Options& options,
                            const AdaptiveRuleFactory& make);

}  // namespace fde
