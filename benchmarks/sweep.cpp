#include "sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>

#include "experiment.hpp"

namespace fde {

std::string SceneVariant::label() const {
  std::string text(maker->id);
  for (const auto& [name, value] : values) {
    text += fmt::format("{}{}={}", text.size() == maker->id.size() ? ':' : ',', name, value);
  }
  return text;
}

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
  SceneRuns missing{variant.label(), make_scene(*variant.maker, variant.values)};
  for (const auto* scheme : sweep.schemes) {
    for (const int steps : sweep.steps) {
      if (!hooks.has(missing.label, std::string(scheme->id), steps)) missing.runs.push_back({scheme, steps});
    }
  }
  return missing;
}

// Calls task(0), ..., task(count - 1), each once, on that many threads. Rethrows what a task throws, after
// all threads have ended.
void in_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  {
    std::vector<std::jthread> workers;
    for (unsigned worker = 0; worker < std::max(1U, threads); ++worker) {
      workers.emplace_back([&] {
        try {
          for (auto i = next++; i < count; i = next++) task(i);
        } catch (...) {
          const std::scoped_lock lock(mutex);
          failure = std::current_exception();
        }
      });
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace

void run_sweep(const Sweep& sweep, const SweepHooks& hooks) {
  std::vector<SceneRuns> scenes;
  std::size_t total = 0, done = 0;
  for (const auto& variant : sweep.scenes) {
    scenes.push_back(missing_runs(variant, sweep, hooks));
    total += 2 * scenes.back().runs.size();
  }
  std::mutex mutex;
  const auto tell = [&](const SceneRuns& of, const SceneRuns::Run& run, std::string_view what) {
    const std::scoped_lock lock(mutex);
    hooks.progress(done++, total, fmt::format("{} {} N = {}{}", of.label, run.scheme->id, run.steps, what));
  };
  in_parallel(scenes.size(), sweep.threads, [&](std::size_t i) {
    auto& of = scenes[i];
    TruthTable truth(of.scene);
    for (auto& run : of.runs) {
      tell(of, run, "");
      run.examination = examine(of.label, of.scene, truth, *run.scheme, run.steps);
    }
  });
  for (auto& of : scenes) {
    for (auto& run : of.runs) {
      tell(of, run, ", time");
      time_solves(run.examination, of.scene, *run.scheme, sweep.repeats);
      hooks.append(run.examination.rows);
    }
  }
  hooks.progress(total, total, "done");
}

}  // namespace fde
