#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command/arguments.hpp"
#include "scenes/scene.hpp"
#include "stepping/scheme.hpp"

namespace fde {

// What `solve` is told of a run, as texts; --until belongs to the scene.
struct RunArguments {
  std::string scheme;
  std::optional<std::string> steps, accuracy, at, every, points, threads, checkpoint, checkpoint_every, field;
  MeansArguments means{.budget = "3600"};
  bool check = false;
  bool events = false;  // the events in place of times
  bool all = false;     // all solutions of a problem at both ends that a search finds
};

// The same, read: one run of a scheme that does not refuse it.
struct AskedRun {
  const Scheme& scheme;
  Setup setup;
  Resolution resolution;
  std::optional<Grid> grid;   // over which it steps; empty: it chooses its times
  std::vector<double> times;  // to print; empty: all
  Options options;            // but for the times
  bool keeps_states = false;  // at the times to print, for the field
  std::string chosen_grid{};  // by graded:auto; empty: it was not asked
};

// Throws std::invalid_argument naming the argument, the text and what is allowed.
AskedRun asked_run(const Scene& scene, const RunArguments& arguments);

}  // namespace fde
