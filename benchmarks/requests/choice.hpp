// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/measures/error_kind.hpp"
#include "fdebench/benchmarks/measures/own_measure.hpp"
#include "fdebench/benchmarks/requests/own_problem.hpp"
#include "fdebench/benchmarks/requests/recommendation.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/benchmarks/search/accuracy_target.hpp"
#include "fdebench/benchmarks/text/range.hpp"

namespace fde::bench {

// The errors that may be asked for, and the seconds that a search may take.
inline constexpr Range searched_errors{.low = 1e-15, .high = 1.0, .open_low = true, .open_high = true};
inline constexpr Range searched_seconds{.low = 0.0, .high = 1e6, .open_low = true};

// What is asked of choose().
struct ChoiceRequest {
  double error = 0.0;
  ErrorKind kind{Norm::maximum, Scale::mixed};
  std::vector<std::string> columns{};    // that count; empty: all
  double seconds = 60.0;                 // for the search
  bool first_run = false;                // ranks by the first run of a process, otherwise by a later one
  std::vector<const Scheme*> schemes{};  // of the caller, tried beside ours; each has an id of its own
  std::vector<OwnMeasure> measures{};    // of the caller, taken of the best run of each scheme
};

// true for "1", the first run of a process, and false for "many". Throws Refusal.
bool parse_first_run(std::string_view text);

// Searches for the scheme, grid and number of steps that reach the error in the least time. Where there is no
// reference, an error estimate takes up to a third of the seconds. `settings` name the scene in the answer;
// by default it is a problem of the caller, which no command knows. Throws Refusal naming the field;
// std::runtime_error where there is neither reference nor estimate, or none as accurate as the error; and
// NumericalFailure, which is one, where no run is within the error.
Recommendation choose(Scene scene, const ChoiceRequest& request,
                      const SceneSettings& settings = {.id = own_id}, const SearchProgress& progress = {});

// Throws NumericalFailure, with what is missing, unless some run is within the accuracy.
void require_option(const Recommendation& made);

}  // namespace fde::bench
