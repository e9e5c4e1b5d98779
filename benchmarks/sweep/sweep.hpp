#pragma once

#include <functional>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "external/external_program.hpp"
#include "records/recorded_run.hpp"
#include "scenes/variant.hpp"
#include "stepping/scheme.hpp"
#include "sweep/experiment.hpp"
#include "sweep/ladder.hpp"

namespace fde {

// Which runs: every scheme, and every program behind them, climbs the ladder on every scene. Programs take
// numbers of steps only.
struct Sweep {
  std::vector<SceneVariant> scenes;
  std::vector<const Scheme*> schemes;
  std::vector<ExternalProgram> programs{};
  Ladder ladder;
  Setup setup{.budget = 600.0};  // of all runs, but for the resolution
  bool optimal_grids = false;    // each scheme on the grid that the orders ask for, not on that of the setup
  std::vector<const Scheme*> graded{};  // these on both, where solutions start singular
  Repeats repeats{};
  unsigned threads = std::thread::hardware_concurrency();  // of the part that is not timed
};

// The setups of the lines that a scheme climbs on a problem: one, or two where it is graded.
std::vector<Setup> setups_of(const Sweep& sweep, const Scheme& scheme, const Problem& problem);

// The runs that a sweep is expected to take, and the seconds that each adds to it.
using Forecast = std::map<RunKey, double>;

// What a sweep is about to do to a run, or that it is done; or that its line ends: no other run of the scene
// and the scheme is to come.
struct SweepEvent {
  enum class Kind { examines, times, is_done, line_ends };
  Kind kind;
  RunKey run;
};

// Runs what is not recorded yet, each once. The rungs are taken one after the other: first those of all
// scenes are examined, as many scenes side by side as there are threads, then their solves are timed, each
// alone on the machine; then it is decided who climbs on, from what is recorded and what was measured alike.
// So a sweep that is continued takes the same runs. Rows go to `append` as soon as they are made: a call for
// each examination and one for each run's times. The runs of a scene and a rung keep the order of the
// schemes; those of scenes side by side mix, and the scene that is expected to take longest begins. Neither
// the number of threads nor the forecast changes a bit of the rows but the times. `append` and `tell` are
// called by one thread at a time.
struct SweepHooks {
  std::function<RecordedRun(const RunKey&)> recorded;
  std::function<void(const std::vector<Record>&)> append;
  std::function<void(const SweepEvent&)> tell;
};
void run_sweep(const Sweep& asked, const SweepHooks& hooks, const Forecast& expected = {});

}  // namespace fde
