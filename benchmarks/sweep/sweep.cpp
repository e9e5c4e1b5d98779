#include "sweep/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <span>

#include "sweep/experiment.hpp"
#include "sweep/in_parallel.hpp"

namespace fde {

namespace {

// The runs of one scene, examined by one thread.
struct SceneRuns {
  struct Run {
    const Scheme* scheme;
    int steps;
    Stage stage;
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
      const Stage stage = hooks.stage(missing.label, std::string(scheme->id), steps);
      if (!listed && stage != Stage::done) missing.runs.push_back({scheme, steps, stage});
    }
  }
  return missing;
}

// The hooks as threads may call them. A failure to append ends the work of all.
class SweepLog {
 public:
  SweepLog(const SweepHooks& hooks, std::size_t total) : hooks_(hooks), total_(total) {}

  void tell(const SceneRuns& of, const SceneRuns::Run& run, std::string_view what) {
    const std::scoped_lock lock(mutex_);
    hooks_.progress(done_++, total_,
                    fmt::format("{} {} N = {}{}", of.label, run.scheme->id, run.steps, what));
  }
  void pass(std::size_t count) {
    const std::scoped_lock lock(mutex_);
    done_ += count;
  }
  void append(const std::vector<Record>& rows) {
    const std::scoped_lock lock(mutex_);
    if (failed_) return;
    try {
      hooks_.append(rows);
    } catch (...) {
      failed_ = true;
      throw;
    }
  }
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  const SweepHooks& hooks_;
  std::size_t total_, done_ = 0;
  std::mutex mutex_;
  std::atomic<bool> failed_ = false;
};

void examine_runs(SceneRuns& of, double budget, SweepLog& log) {
  WatchedReference reference(of.scene);
  for (auto& run : of.runs) {
    if (log.failed()) return;
    if (run.stage == Stage::examined) {
      log.pass(1);
      continue;
    }
    log.tell(of, run, "");
    const auto rows = examine(of.label, of.scene, reference, *run.scheme, run.steps, budget);
    log.append(rows);
    run.stage = is_compared(ending_of(rows.back().status)) ? Stage::examined : Stage::done;
    if (run.stage == Stage::done) log.pass(1);
  }
}

void time_runs(const SceneRuns& of, int repeats, SweepLog& log) {
  for (const auto& run : of.runs) {
    if (run.stage != Stage::examined) continue;
    log.tell(of, run, ", time");
    log.append(time_solves(of.label, of.scene, *run.scheme, run.steps, repeats));
  }
}

}  // namespace

void run_sweep(const Sweep& sweep, const SweepHooks& hooks) {
  std::vector<SceneRuns> scenes;
  std::size_t total = 0;
  for (const auto& variant : sweep.scenes) {
    if (std::ranges::find(scenes, variant.label(), &SceneRuns::label) != scenes.end()) continue;
    scenes.push_back(missing_runs(variant, sweep, hooks));
    total += 2 * scenes.back().runs.size();
  }
  SweepLog log(hooks, total);
  const std::size_t batch = std::max(1U, sweep.threads);
  for (std::size_t first = 0; first < scenes.size(); first += batch) {
    const auto some = std::span(scenes).subspan(first, std::min(batch, scenes.size() - first));
    in_parallel(some.size(), sweep.threads, [&](std::size_t i) { examine_runs(some[i], sweep.budget, log); });
    for (const auto& of : some) time_runs(of, sweep.repeats, log);
  }
  hooks.progress(total, total, "done");
}

}  // namespace fde
