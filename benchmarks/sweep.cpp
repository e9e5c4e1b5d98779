#include "sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <span>

#include "experiment.hpp"
#include "in_parallel.hpp"

namespace fde {

namespace {

// The runs of one scene, examined by one thread.
struct SceneRuns {
  struct Run {
    const Scheme* scheme;
    int steps;
    Examination examination{};
  };
  std::string label;
  Scene scene;
  std::vector<Run> runs{};
};

SceneRuns missing_runs(const SceneVariant& variant, const Sweep& sweep, const SweepHooks& hooks) {
  SceneRuns missing{variant.label(), make_scene(variant)};
  for (const auto* scheme : sweep.schemes) {
    for (const int steps : sweep.steps) {
      const bool listed = std::ranges::any_of(
          missing.runs, [&](const auto& run) { return run.scheme == scheme && run.steps == steps; });
      if (listed || hooks.has(missing.label, std::string(scheme->id), steps)) continue;
      missing.runs.push_back({scheme, steps});
    }
  }
  return missing;
}

}  // namespace

void run_sweep(const Sweep& sweep, const SweepHooks& hooks) {
  std::vector<SceneRuns> scenes;
  std::size_t total = 0, done = 0;
  for (const auto& variant : sweep.scenes) {
    if (std::ranges::find(scenes, variant.label(), &SceneRuns::label) != scenes.end()) continue;
    scenes.push_back(missing_runs(variant, sweep, hooks));
    total += 2 * scenes.back().runs.size();
  }
  std::mutex mutex;
  const auto tell = [&](const SceneRuns& of, const SceneRuns::Run& run, std::string_view what) {
    const std::scoped_lock lock(mutex);
    hooks.progress(done++, total, fmt::format("{} {} N = {}{}", of.label, run.scheme->id, run.steps, what));
  };
  const std::size_t batch = std::max(1U, sweep.threads);
  for (std::size_t first = 0; first < scenes.size(); first += batch) {
    const auto some = std::span(scenes).subspan(first, std::min(batch, scenes.size() - first));
    in_parallel(some.size(), sweep.threads, [&](std::size_t i) {
      auto& of = some[i];
      TruthTable truth(of.scene);
      for (auto& run : of.runs) {
        tell(of, run, "");
        run.examination = examine(of.label, of.scene, truth, *run.scheme, run.steps, sweep.budget);
      }
    });
    for (auto& of : some) {
      for (auto& run : of.runs) {
        tell(of, run, ", time");
        time_solves(run.examination, of.scene, *run.scheme, sweep.repeats);
        hooks.append(run.examination.rows);
      }
    }
  }
  hooks.progress(total, total, "done");
}

}  // namespace fde
