#include "sweep.hpp"

#include <fmt/format.h>

#include "experiment.hpp"

namespace fde {

std::string SceneVariant::label() const {
  std::string text(maker->id);
  for (const auto& [name, value] : values) {
    text += fmt::format("{}{}={}", text.size() == maker->id.size() ? ':' : ',', name, value);
  }
  return text;
}

void run_sweep(const Sweep& sweep, const SweepHooks& hooks) {
  const std::size_t total = sweep.scenes.size() * sweep.schemes.size() * sweep.steps.size();
  std::size_t done = 0;
  for (const auto& variant : sweep.scenes) {
    const Scene scene = make_scene(*variant.maker, variant.values);
    const std::string label = variant.label();
    TruthTable truth(scene);
    for (const auto* scheme : sweep.schemes) {
      for (const int steps : sweep.steps) {
        hooks.progress(done++, total, fmt::format("{} {} N = {}", label, scheme->id, steps));
        if (hooks.has(label, std::string(scheme->id), steps)) continue;

        hooks.append(run_experiment(label, scene, truth, *scheme, steps, sweep.repeats));
      }
    }
  }
  hooks.progress(total, total, "done");
}

}  // namespace fde
