#pragma once

#include <optional>
#include <span>
#include <vector>

#include "records/recorded_run.hpp"
#include "records/setup.hpp"

namespace fde {

// What a ladder is climbed for: the cheapest run within each of some errors, at the end and as maxima.
struct Goal {
  std::vector<double> errors{1e-2, 1e-4, 1e-6, 1e-8};
  double most_seconds = 0.3;  // of a solve: what takes longer is no answer
  double margin = 2.0;        // by which the forecast of another scheme's time may be wrong
};

// The numbers of steps, and the accuracies, that schemes get on a scene, the coarsest first: all of them, or
// as many steps as a goal needs.
struct Ladder {
  std::vector<StepsOrAccuracy> rungs{};
  std::optional<Goal> goal{};
};

// What is on it for schemes over a grid, or for those that choose their steps: the rungs of that kind. Where
// it has none, all rungs: each is refused.
Ladder ladder_for(const Ladder& ladder, const Needs& needs);

// An error, and the rate that theory expects of it.
struct FallingError {
  std::optional<double> error{}, rate{};
  bool at_floor = false;  // it is that of rounding, or of the reference

  bool operator==(const FallingError&) const = default;
};

// What a run says of those with more steps.
struct Rung {
  int steps = 0;
  bool hopeless = false;            // more steps end in the same way: refused, without a reference, ...
  FallingError end{}, maximum{};    // absolute; those on the mixed scale are no larger
  std::optional<double> seconds{};  // of a solve
  bool wall_clock = false;          // of a whole process
};
using ErrorOfRung = FallingError Rung::*;
Rung rung_of(const Setup& setup, const RecordedRun& run);

// The rungs that one scheme has taken on a scene, the coarsest first.
using Climb = std::vector<Rung>;

// The seconds of the first rung that is within the error: measured, or as the error is forecast to fall. The
// forecast takes the observed rate or the expected one: the smaller, or where it is `hopeful` the larger and
// a half more. nullopt: no rung is, or nothing is known.
std::optional<double> seconds_needed(const Ladder& ladder, const Climb& climb, ErrorOfRung of, double error,
                                     bool hopeful);

// Whether the rungs that are left cannot change an answer, so that the climb ends. One of all climbs of a
// scene ends
//   - at the top, or where its rung is hopeless;
//   - where the next rung is forecast to take more than most_seconds, the start of a process not counted.
// One of steps ends, too,
//   - within the least error of the goal, or at the floor, in both norms;
//   - from the fifth rung on, with which a rate is known, where each error not reached is out of its hopeful
//     reach, or another climb is within it in less time, by its measured or its forecast seconds;
//   - from the fifth rung on, where a climb listed before has the same errors to the last bit: both schemes
//     are one algorithm on this scene.
// Without a goal only at the top.
bool has_ended(const Ladder& ladder, std::span<const Climb> of_scene, const Climb& climb);

}  // namespace fde
