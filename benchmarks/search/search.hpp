// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/benchmarks/search/accuracy_target.hpp"
#include "fdebench/benchmarks/search/search_candidate.hpp"

namespace fde::bench {

// Searches for `seconds` for the cheapest run of a scene within the accuracy of the target, over all
// schemes of ours and of the caller's `own`, gradings and numbers of steps. Every configuration makes the
// runs of next_resolutions() (next_resolution.hpp) until none may be the cheapest. The quickest
// configurations are timed against each other, and the best is compared with the reference at as many steps
// as a record is. Returns all configurations: first those within the accuracy, the quickest first. Throws
// std::runtime_error if the reference is missing or less accurate than requested.
std::vector<SearchCandidate> search(const Scene& scene, const AccuracyTarget& target, double seconds,
                                    const SearchProgress& progress, std::span<const Scheme* const> own = {});

}  // namespace fde::bench
