// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/requests/recommendation.hpp"
#include "fdebench/benchmarks/search/accuracy_target.hpp"
#include "fdebench/benchmarks/search/search_candidate.hpp"

namespace fde::bench {

// A recommendation from the result of search(). `columns` are the names of the scene's columns; `estimate` is
// given if the errors are estimated.
Recommendation recommend(const std::vector<SearchCandidate>& searched, const SceneSettings& scene,
                         const std::vector<std::string>& columns, const AccuracyTarget& target,
                         const std::optional<ErrorEstimate>& estimate = {});

}  // namespace fde::bench
