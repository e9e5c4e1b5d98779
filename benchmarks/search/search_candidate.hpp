// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/measures/timing_conditions.hpp"
#include "fdebench/benchmarks/search/configuration.hpp"
#include "fdebench/benchmarks/search/error_model.hpp"
#include "fdebench/benchmarks/search/refinement.hpp"

namespace fde::bench {

// The outcome of the search for one configuration.
enum class SearchOutcome {
  accuracy_reached,  // `best` is within the accuracy
  slower,            // its finest run is outside the accuracy and takes longer than the best one
  expected_slower,   // by its errors so far it takes longer than the best one
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
  Refinement refinement{};                   // its runs
  RefinementRun best{};                      // the cheapest run within the accuracy
  std::optional<Prediction> predicted{};     // error of `best`, by the runs with fewer steps
  std::optional<MedianInterval> time{};      // of `best`, interleaved with the other quick configurations
  std::optional<double> rate{};              // observed
  std::optional<Prediction> steps_needed{};  // to reach the accuracy, where no run did
  double seconds_per_step = 0.0;             // in the finest run
};

}  // namespace fde::bench
