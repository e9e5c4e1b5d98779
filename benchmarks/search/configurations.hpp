// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/benchmarks/search/configuration.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

// The gradings to try with a scheme: 1 (uniform), 1.5, 2, 3, and the smallest with the best theoretical rate;
// 1 alone for a scheme that needs a uniform grid or takes no grid. Precondition: the scheme accepts the
// scene's problem.
std::vector<double> gradings_of(const Scheme& scheme, const Scene& scene, Norm norm);

// Why the scheme accepts the problem neither on few steps with this grading nor on many, as it does where a
// delay is short, or not with a usual tolerance; nullopt: it does.
std::optional<std::string> refusal(const Scheme& scheme, const Problem& problem, double grading);

// A configuration to try on a scene.
struct ConfigurationChoice {
  Configuration configuration{};
  int unit = 1;                          // its numbers of steps are multiples of it
  std::optional<std::string> refused{};  // why the scheme does not accept the problem; nullopt: it does
};

// Every scheme of ours, and of the caller's `own`, with each of its gradings; once, uniform, where it refuses
// the problem. Where the right-hand side jumps, a scheme over uniform grids is there twice: a rule is more
// accurate where its times contain the jumps, and may be cheaper where they need not.
std::vector<ConfigurationChoice> configurations_of(const Scene& scene, Norm norm,
                                                   std::span<const Scheme* const> own = {});

}  // namespace fde::bench
