#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measures/time_spread.hpp"
#include "search/attempt.hpp"
#include "search/error_model.hpp"

namespace fde {

// What became of a way to solve a scene.
enum class Found {
  within,       // reaches the accuracy, with `best`
  slower,       // would take longer than another way does
  at_floor,     // its error falls no more
  out_of_time,  // there was no time to go on
  repeats,      // gives the bits of another way, which counts for both
  refused,
  failed,
};

// All runs of one way, and what came of it.
struct SearchedWay {
  Way way{};
  Found found = Found::out_of_time;
  std::string reason{};                    // of a refusal, or how its last run ended
  std::vector<std::string> names{};        // its scheme, then those that give the same bits
  std::vector<Attempt> ladder{};           // with doubled numbers of steps
  Attempt best{};                          // the cheapest within the accuracy
  std::optional<Expected> predicted{};     // its error, by the ladder alone
  std::optional<TimeSpread> time{};        // of `best`, against the others that are as quick
  std::optional<double> rate{};            // observed
  std::optional<Expected> steps_needed{};  // to the accuracy, of one that was not there
  double step_seconds = 0.0;               // a step takes, with as many as it came to
  double once_seconds = 0.0;               // more for the first solve, which makes start weights
};

// The errors of its ladder that are numbers, the coarsest first.
std::vector<ErrorWith> errors_of(const SearchedWay& of);

// Whether its errors have begun to fall as they will go on.
bool has_begun(const SearchedWay& of);

// Whether its errors, far below the size of the solution, fall no more.
bool is_at_floor(const SearchedWay& of);

// That the next rung is expected to take.
double next_seconds(const SearchedWay& of);

// That a run within the accuracy is expected to take, with fewer steps or more as the errors leave it open;
// infinity where its errors have not begun to fall as they will go on, or its steps to cost what they will.
double expected_seconds(const SearchedWay& of, double accuracy, double Expected::*steps);

// The least that it takes, as far as can be told: more than the last rung where errors and steps tell.
double least_seconds(const SearchedWay& of, double accuracy);

// The gradings over which a scheme that takes the scene's problem is tried: the uniform grid, some usual
// ones, and the least that has the best rate in theory.
std::vector<double> gradings_of(const Scheme& scheme, const Scene& scene, Norm norm);

}  // namespace fde
