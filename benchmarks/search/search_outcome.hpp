// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/search/search_candidate.hpp"

namespace fde::bench {

// Sets the outcome of a configuration by its runs, with what follows from it: the best run within the target
// and its predicted error, or why there is none and the steps that it would take. `quickest`: the seconds of
// the quickest run of all configurations, infinity if there is none. `has_time`: the search did not end for
// lack of time. Refused and duplicate configurations keep their outcome.
void conclude(SearchCandidate& of, const ErrorTarget& target, double quickest, bool has_time);

}  // namespace fde::bench
