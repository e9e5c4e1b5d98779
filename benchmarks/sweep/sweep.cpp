// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/sweep.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/scenes/start_time.hpp"
#include "fdebench/benchmarks/sweep/described_scene.hpp"
#include "fdebench/benchmarks/sweep/in_parallel.hpp"
#include "fdebench/benchmarks/sweep/scene_refinements.hpp"

namespace fde::bench {

namespace {

// A scene with all its runs. Examined by one thread.
struct SweptScene {
  SweptScene(SceneVariant swept, const Sweep& sweep)
      : variant(std::move(swept)),
        name(variant.key()),
        scene(make_scene(variant)),
        refinements(sweep, name, &scene.problem),
        current(refinements.series.size()) {
    require_start_at_zero(scene, "runs that are recorded");
  }

  SceneVariant variant;
  SceneSettings name;
  Scene scene;
  std::shared_ptr<MemoizedReference> reference = std::make_shared<MemoizedReference>(scene);
  SceneRefinements refinements;
  std::vector<std::optional<Record>> current;  // the current run of each series; nullopt: not examined
};

// The callbacks, guarded by a mutex. After append() has thrown, all threads stop.
class GuardedCallbacks {
 public:
  explicit GuardedCallbacks(const SweepCallbacks& callbacks) : hooks_(callbacks) {}

  void on_event(SweepEvent::Kind kind, const RunKey& run, bool with_reference = false) {
    const std::scoped_lock lock(mutex_);
    hooks_.on_event({kind, run, with_reference});
  }
  void append(const Record& run) {
    write([&] { hooks_.append(run); });
  }
  void append_times(const Record& run) {
    write([&] { hooks_.append_times(run); });
  }
  void append(const SceneDescription& scene) {
    write([&] { hooks_.append_scene(scene); });
  }
  [[nodiscard]] bool describes(const SceneSettings& scene) {
    const std::scoped_lock lock(mutex_);
    return !hooks_.append_scene || hooks_.describes(scene);
  }
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  template <class Write>
  void write(const Write& append) {
    const std::scoped_lock lock(mutex_);
    if (failed_) return;
    try {
      append();
    } catch (...) {
      failed_ = true;
      throw;
    }
  }

  const SweepCallbacks& hooks_;
  std::mutex mutex_;
  std::atomic<bool> failed_ = false;
};

// What the sweep leaves to do of a run.
bool is_timed_next(const Record& run, const Sweep& sweep) {
  if (sweep.examines_only) return false;
  if (!run.is_complete()) return true;
  return sweep.retimes && run.timing.is_disturbed() && run.timing.count < most_timings;
}

Record examine(SweptScene& of, const RefinementSeries& line, const Sweep& sweep) {
  if (const auto* program = std::get_if<const ExternalProgram*>(&line.solver))
    return examine(of.variant, of.scene, *of.reference, **program, line.settings);
  return examine(of.name, of.scene, *of.reference, *std::get<const Scheme*>(line.solver), line.settings,
                 sweep.measures);
}

// Times the current run. A program may fail then; its run is examined anew.
void time(const SweptScene& of, const RefinementSeries& line, Record& run, const TimingRepeats& repeats,
          GuardedCallbacks& log) {
  if (const auto* scheme = std::get_if<const Scheme*>(&line.solver)) {
    run.take(time_solves(of.scene, **scheme, line.settings, repeats));
  } else {
    time_runs(run, of.variant, of.scene, *std::get<const ExternalProgram*>(line.solver), line.settings,
              repeats.most, repeats.enough_seconds);
  }
  run.timing.values.empty() ? log.append(run) : log.append_times(run);
}

void examine_runs(SweptScene& of, const Sweep& sweep, GuardedCallbacks& log) {
  for (std::size_t i = 0; i < of.current.size(); ++i) {
    const RefinementSeries& line = of.refinements.series[i];
    if (log.failed()) return;
    if (!line.is_due || of.current[i]) continue;
    log.on_event(SweepEvent::Kind::examines, line.key, !of.reference->is_begun());
    of.current[i] = examine(of, line, sweep);
    if (!log.describes(of.name))
      log.append(describe(of.variant, of.scene, *of.reference, sweep.describes_solutions));
    log.append(*of.current[i]);
    if (sweep.examines_only || of.current[i]->is_complete())
      log.on_event(SweepEvent::Kind::is_done, line.key);
  }
}

void time_runs(SweptScene& of, const Sweep& sweep, GuardedCallbacks& log) {
  for (std::size_t i = 0; i < of.current.size(); ++i) {
    const RefinementSeries& line = of.refinements.series[i];
    if (!line.is_due || !is_timed_next(*of.current[i], sweep)) continue;
    log.on_event(SweepEvent::Kind::times, line.key);
    time(of, line, *of.current[i], sweep.repeats, log);
    log.on_event(SweepEvent::Kind::is_done, line.key);
  }
}

// Chooses the next runs of the scene. Returns whether there is any.
bool choose_next_runs(SweptScene& of, const SweepPlan& plan, const SweepCallbacks& callbacks,
                      GuardedCallbacks& log) {
  auto& series = of.refinements.series;
  const std::vector<RefinementSeries> before = series;
  const bool is_any = of.refinements.choose_next(plan);
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (series[i].ended && !before[i].ended && of.refinements.has_runs(i))
      log.on_event(SweepEvent::Kind::refinement_ends, series[i].key);
    if (series[i].is_due) of.current[i] = callbacks.recorded(series[i].key);
  }
  return is_any;
}

void add_runs(SweptScene& of) {
  for (std::size_t i = 0; i < of.current.size(); ++i) {
    if (of.refinements.series[i].is_due) of.refinements.add(i, refinement_run(*of.current[i]));
  }
}

// Scenes with the same exact columns share one reference and are examined by one thread.
struct SceneGroup {
  std::vector<SweptScene*> scenes{};
  double seconds = 0.0;  // of the examinations of the last turn
};

std::vector<SceneGroup> grouped_by_solution(std::deque<SweptScene>& scenes) {
  std::map<std::pair<SceneSettings, std::vector<std::string>>, SceneGroup> groups;
  for (auto& of : scenes)
    groups[{of.variant.key_of_solution(), of.scene.outputs.names}].scenes.push_back(&of);
  std::vector<SceneGroup> all;
  for (auto& [solution, group] : groups) {
    for (SweptScene* of : group.scenes) of->reference = group.scenes.front()->reference;
    all.push_back(std::move(group));
  }
  return all;
}

void examine_group(SceneGroup& group, const Sweep& sweep, GuardedCallbacks& log) {
  const auto start = std::chrono::steady_clock::now();
  for (SweptScene* of : group.scenes) examine_runs(*of, sweep, log);
  group.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Makes the next runs of all scenes, those that took longest in the last turn first, so that the threads
// finish at about the same time. Returns whether there was any.
bool take_turn(std::deque<SweptScene>& scenes, std::vector<SceneGroup>& groups, const Sweep& sweep,
               const SweepCallbacks& callbacks, GuardedCallbacks& log) {
  std::atomic<bool> goes_on = false;
  in_parallel(scenes.size(), sweep.threads, [&](std::size_t i) {
    if (choose_next_runs(scenes[i], sweep.plan, callbacks, log)) goes_on = true;
  });
  if (sweep.threads > 1) std::ranges::stable_sort(groups, std::ranges::greater{}, &SceneGroup::seconds);
  in_parallel(groups.size(), sweep.threads, [&](std::size_t i) { examine_group(groups[i], sweep, log); });
  for (auto& of : scenes) time_runs(of, sweep, log);
  for (auto& of : scenes) add_runs(of);
  return goes_on;
}

}  // namespace

void run_sweep(const Sweep& requested, const SweepCallbacks& callbacks) {
  Sweep sweep = requested;
  sweep.plan.resolutions.clear();
  for (const auto& resolution : requested.plan.resolutions) {
    if (std::ranges::find(sweep.plan.resolutions, resolution) == sweep.plan.resolutions.end())
      sweep.plan.resolutions.push_back(resolution);
  }
  std::set<SceneSettings> known;
  std::erase_if(sweep.scenes, [&](const auto& variant) { return !known.insert(variant.key()).second; });
  GuardedCallbacks log(callbacks);
  for (std::size_t begin = 0; begin < sweep.scenes.size(); begin += scenes_at_once) {
    std::deque<SweptScene> scenes;
    for (auto i = begin; i < std::min(begin + scenes_at_once, sweep.scenes.size()); ++i)
      scenes.emplace_back(sweep.scenes[i], sweep);
    auto groups = grouped_by_solution(scenes);
    while (take_turn(scenes, groups, sweep, callbacks, log)) {
    }
  }
}

}  // namespace fde::bench
