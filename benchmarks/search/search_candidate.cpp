// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/search_candidate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "fdebench/schemes/stepping/rates.hpp"

namespace fde::bench {
namespace {

// From this number of steps on the history uses sums of exponentials, and the cost of a step is constant.
constexpr int settled_steps = 8192;

}  // namespace

std::vector<TrialError> errors_of(const SearchCandidate& of) {
  std::vector<TrialError> errors;
  for (const CandidateRun& attempt : of.refinements) {
    if (std::isfinite(attempt.error)) errors.push_back({attempt.steps, attempt.error});
  }
  return errors;
}

bool is_asymptotic(const SearchCandidate& of) {
  constexpr double begun = 0.1;
  return !of.refinements.empty() &&
         of.refinements.back().error < begun * of.refinements.back().baseline_error;
}

bool has_stagnated(const SearchCandidate& of) {
  constexpr double small = 1e-8, falling = 0.7;
  const auto& refinements = of.refinements;
  if (refinements.size() < 3) return false;
  const double last = refinements.back().error, before = refinements[refinements.size() - 2].error,
               first = refinements[refinements.size() - 3].error;
  return last < small * refinements.back().baseline_error && last > falling * before &&
         before > falling * first;
}

double next_seconds(const SearchCandidate& of) {
  constexpr double max_growth = 16.0;
  if (of.refinements.size() < 2) return 0.0;
  const double last = of.refinements.back().seconds,
               before = of.refinements[of.refinements.size() - 2].seconds;
  return last * std::clamp(last / before, 2.0, max_growth);
}

double expected_seconds(const SearchCandidate& of, double accuracy, double Prediction::*steps) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!is_asymptotic(of) || of.refinements.back().steps < settled_steps) return infinity;
  const ErrorModel model(errors_of(of));
  return model.empty() ? infinity : of.seconds_per_step * (model.steps(accuracy).*steps);
}

double lower_bound_of_seconds(const SearchCandidate& of, double accuracy) {
  constexpr double hope = 0.8, open = 0.25;
  if (of.refinements.empty()) return 0.0;
  const CandidateRun& last = of.refinements.back();
  const double expected = expected_seconds(of, accuracy, &Prediction::low);
  if (std::isfinite(expected)) return hope * expected;
  return (last.steps < settled_steps ? open : hope) * last.seconds;
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
