#pragma once

#include <functional>
#include <string>
#include <vector>

#include "search/attempt.hpp"
#include "search/error_model.hpp"
#include "search/interleaved_times.hpp"

namespace fde {

// What became of a way to solve a scene.
enum class Found {
  within,       // reaches the accuracy, with `best`
  slower,       // would take longer than another way does
  at_floor,     // its error falls no more
  out_of_time,  // there was no time to go on
  repeats,      // gives the bits of another way, which counts for both
  refused,
  fails,
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
};

// The gradings over which a scheme is tried on a scene: the uniform grid, some usual ones, and the least that
// has the best rate in theory.
std::vector<double> gradings_of(const Scheme& scheme, const Scene& scene, Norm norm);

// Looks for the cheapest run of a scene that answers a question, over all schemes, gradings and numbers of
// steps, for so many seconds. Every way doubles its steps until it is within the accuracy, or is known to be
// slower than another. Then the fewest steps are found between the last two by the error model, each taken by
// a run; at the end, where an error may pass through 0, all numbers below them in steps of a twentieth. The
// quickest are timed against each other, and the first of them is compared with the reference at as many
// steps as records are. First those within the accuracy, the quickest first. tell hears what is tried.
std::vector<SearchedWay> search(const Scene& scene, const Question& question, double seconds,
                                const std::function<void(const std::string& what, double part)>& tell);

}  // namespace fde
