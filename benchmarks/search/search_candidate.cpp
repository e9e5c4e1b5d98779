// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/search_candidate.hpp"

#include <algorithm>

namespace fde::bench {

const CandidateRun* SearchCandidate::finest() const {
  const auto fineness = [](const CandidateRun& run) {
    return run.requested_tolerance ? -*run.requested_tolerance : run.steps;
  };
  const auto found = std::ranges::max_element(runs, {}, fineness);
  return found == runs.end() ? nullptr : &*found;
}

}  // namespace fde::bench
