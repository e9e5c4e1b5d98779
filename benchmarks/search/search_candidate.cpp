// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/search_candidate.hpp"

#include <algorithm>
#include <tuple>

#include "fdebench/schemes/stepping/rates.hpp"

namespace fde::bench {
const CandidateRun* SearchCandidate::finest() const {
  const auto fineness = [](const CandidateRun& run) {
    return run.requested_tolerance ? -*run.requested_tolerance : run.steps;
  };
  const auto found = std::ranges::max_element(runs, {}, fineness);
  return found == runs.end() ? nullptr : &*found;
}

std::vector<double> gradings_of(const Scheme& scheme, const Scene& scene, Norm norm) {
  std::vector<double> gradings{1.0};
  if (scheme.capabilities.uniform_grid || scheme.capabilities.is_adaptive()) return gradings;
  gradings.insert(gradings.end(), {1.5, 2.0, 3.0});
  constexpr double most = 10.0, step = 0.25;
  double best = 1.0, best_rate = 0.0;
  for (double grading = 1.0; grading <= most; grading += step) {
    const auto rate = theoretical_rate(scheme, scene.problem, scene.smoothness, grading, norm);
    if (!rate) return gradings;
    if (*rate > best_rate + 1e-9) std::tie(best, best_rate) = std::tuple(grading, *rate);
  }
  if (std::ranges::find(gradings, best) == gradings.end()) gradings.push_back(best);
  return gradings;
}

}  // namespace fde::bench
