// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/measures/time_spread.hpp"
#include "fdebench/benchmarks/search/candidate_run.hpp"
#include "fdebench/benchmarks/search/error_model.hpp"

namespace fde::bench {

// The outcome of the search for one configuration.
enum class SearchOutcome {
  accuracy_reached,  // `best` is within the accuracy
  slower,            // expected to take longer than another configuration
  stagnated,         // the error no longer decreases
  out_of_time,       // the time of the search ended first
  duplicate,         // gives the same bits as another configuration, whose entry names both
  refused,
  failed,
};

// All runs of one configuration and their outcome.
struct SearchCandidate {
  Configuration configuration{};
  SearchOutcome outcome = SearchOutcome::out_of_time;
  std::string reason{};                      // why the scheme refused, or how the last run ended
  std::vector<std::string> names{};          // this scheme, then the schemes that give the same bits
  std::vector<CandidateRun> refinements{};   // runs with doubled numbers of steps
  CandidateRun best{};                       // the cheapest run within the accuracy
  std::optional<Prediction> predicted{};     // error of `best` by the error model of `refinements`
  std::optional<MedianInterval> time{};      // of `best`, interleaved with the other quick configurations
  std::optional<double> rate{};              // observed
  std::optional<Prediction> steps_needed{};  // to reach the accuracy, where no run did
  double seconds_per_step = 0.0;             // per step, in the run with the most steps
  double setup_seconds = 0.0;                // extra time of the first solve, which computes starting weights
};

// The finite errors of the refinements, from coarse to fine.
std::vector<TrialError> errors_of(const SearchCandidate& of);

// Whether the asymptotic range is reached: the last error is below a tenth of the baseline's error.
bool is_asymptotic(const SearchCandidate& of);

// Whether the last three errors, far below the size of the solution, no longer decrease.
bool has_stagnated(const SearchCandidate& of);

// Expected seconds of the next refinement.
double next_seconds(const SearchCandidate& of);

// Expected seconds of a run within the accuracy, for the given end (`low`, `value`, `high`) of the interval
// of its steps. Infinity unless the errors are asymptotic (is_asymptotic) and the cost of a step is settled.
double expected_seconds(const SearchCandidate& of, double accuracy, double Prediction::*steps);

// A lower estimate of the seconds of a run within the accuracy: from expected_seconds() where that is finite,
// otherwise a fraction of the last run's.
double lower_bound_of_seconds(const SearchCandidate& of, double accuracy);

// The gradings to try with a scheme: 1 (uniform), 1.5, 2, 3, and the smallest with the best theoretical rate;
// 1 alone for a scheme that needs a uniform grid or takes no grid. Precondition: the scheme accepts the
// scene's problem.
std::vector<double> gradings_of(const Scheme& scheme, const Scene& scene, Norm norm);

}  // namespace fde::bench
