#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "record.hpp"
#include "scene.hpp"
#include "scheme.hpp"

namespace fde {

// A scene with some parameters replaced. In results and on the command line: "pendulum:alpha=1.9,beta=0.1".
struct SceneVariant {
  const SceneMaker* maker;
  std::map<std::string, double> values{};

  [[nodiscard]] std::string label() const;
};

// Which runs: every scheme on every scene with every number of steps.
struct Sweep {
  std::vector<SceneVariant> scenes;
  std::vector<const Scheme*> schemes;
  std::vector<int> steps;
  int repeats = 3;
};

// Runs what `has` does not know yet, one run after the other (a timed run has the machine to itself). Rows go
// to `append`, one call a run; `progress` hears (done, total, what comes next) before each.
struct SweepHooks {
  std::function<bool(const std::string& scene, const std::string& scheme, int steps)> has;
  std::function<void(const std::vector<Record>&)> append;
  std::function<void(std::size_t done, std::size_t total, const std::string& next)> progress;
};
void run_sweep(const Sweep& sweep, const SweepHooks& hooks);

}  // namespace fde
