#include "sweep.hpp"

#include "experiment.hpp"
#include "fmt/format.h"

namespace fde {

void run_sweep(const Sweep& sweep, const SweepHooks& hooks) {
  const std::size_t total = sweep.scenes.size() * sweep.schemes.size() * sweep.steps.size();
  std::size_t done = 0;
  for (const auto* maker : sweep.scenes) {
    const Scene scene = make_scene(*maker);
    TruthTable truth(scene);
    for (const auto* scheme : sweep.schemes) {
      for (const int steps : sweep.steps) {
        hooks.progress(done++, total, fmt::format("{} {} N = {}", maker->id, scheme->id, steps));
        if (hooks.has(std::string(maker->id), std::string(scheme->id), steps)) continue;

        hooks.append(run_experiment(*maker, scene, truth, *scheme, steps, sweep.repeats));
      }
    }
  }
  hooks.progress(total, total, "done");
}

}  // namespace fde
