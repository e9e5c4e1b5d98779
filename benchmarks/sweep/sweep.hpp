#pragma once

#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "records/results_file.hpp"
#include "scenes/variant.hpp"
#include "stepping/scheme.hpp"

namespace fde {

// Which runs: every scheme on every scene with every resolution.
struct Sweep {
  std::vector<SceneVariant> scenes;
  std::vector<const Scheme*> schemes;
  std::vector<StepsOrAccuracy> resolutions;
  Setup setup{.budget = 600.0};  // of all runs, but for the resolution
  int repeats = 3;
  unsigned threads = std::thread::hardware_concurrency();  // of the part that is not timed
};

// Runs what is not recorded yet, each once. As many scenes as there are threads at a time: first their
// references and measures, side by side, then their timed solves, each alone on the machine. Rows go to
// `append` as soon as they are made: a call for each examination and one for each run's times. The runs of a
// scene keep the order of the lists; those of scenes side by side mix. The number of threads changes no bit
// of the rows but the times. `append` and `progress`, which hears (done, total, what comes next), are called
// by one thread at a time.
struct SweepHooks {
  std::function<Recorded(const RunKey&)> recorded;
  std::function<void(const std::vector<Record>&)> append;
  std::function<void(std::size_t done, std::size_t total, const std::string& next)> progress;
};
void run_sweep(const Sweep& sweep, const SweepHooks& hooks);

}  // namespace fde
