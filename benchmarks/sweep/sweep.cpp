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
    Setup setup;
    Recorded recorded;
  };
  SceneSettings name;
  Scene scene;
  std::vector<Run> runs{};
};

SceneRuns missing_runs(const SceneVariant& variant, const Sweep& sweep, const SweepHooks& hooks) {
  SceneRuns missing{variant.key(), make_scene(variant)};
  for (const auto* scheme : sweep.schemes) {
    for (const auto& resolution : sweep.resolutions) {
      Setup setup = sweep.setup;
      setup.resolution = resolution;
      const bool listed = std::ranges::any_of(
          missing.runs, [&](const auto& run) { return run.scheme == scheme && run.setup == setup; });
      const auto recorded = hooks.recorded({missing.name, std::string(scheme->id), setup});
      if (!listed && recorded != Recorded::everything) missing.runs.push_back({scheme, setup, recorded});
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
    hooks_.progress(
        done_++, total_,
        fmt::format("{} {} {}{}", label_of(of.name), run.scheme->id, resolution_text(run.setup), what));
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

void examine_runs(SceneRuns& of, SweepLog& log) {
  WatchedReference reference(of.scene);
  for (auto& run : of.runs) {
    if (log.failed()) return;
    if (run.recorded == Recorded::all_but_times) {
      log.pass(1);
      continue;
    }
    log.tell(of, run, "");
    const auto rows = examine(of.name, of.scene, reference, *run.scheme, run.setup);
    log.append(rows);
    const bool compared = is_compared(rows.back().ending->kind);
    run.recorded = compared ? Recorded::all_but_times : Recorded::everything;
    if (!compared) log.pass(1);
  }
}

void time_runs(const SceneRuns& of, int repeats, SweepLog& log) {
  for (const auto& run : of.runs) {
    if (run.recorded != Recorded::all_but_times) continue;
    log.tell(of, run, ", time");
    log.append(time_solves(of.name, of.scene, *run.scheme, run.setup, repeats));
  }
}

}  // namespace

void run_sweep(const Sweep& sweep, const SweepHooks& hooks) {
  std::vector<SceneRuns> scenes;
  std::size_t total = 0;
  for (const auto& variant : sweep.scenes) {
    if (std::ranges::find(scenes, variant.key(), &SceneRuns::name) != scenes.end()) continue;
    scenes.push_back(missing_runs(variant, sweep, hooks));
    total += 2 * scenes.back().runs.size();
  }
  SweepLog log(hooks, total);
  const std::size_t batch = std::max(1U, sweep.threads);
  for (std::size_t first = 0; first < scenes.size(); first += batch) {
    const auto some = std::span(scenes).subspan(first, std::min(batch, scenes.size() - first));
    in_parallel(some.size(), sweep.threads, [&](std::size_t i) { examine_runs(some[i], log); });
    for (const auto& of : some) time_runs(of, sweep.repeats, log);
  }
  hooks.progress(total, total, "done");
}

}  // namespace fde
