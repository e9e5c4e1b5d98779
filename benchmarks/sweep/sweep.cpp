// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/sweep.hpp"

#include <algorithm>
#include <atomic>
#include <deque>
#include <mutex>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "fdebench/benchmarks/sweep/described_scene.hpp"
#include "fdebench/benchmarks/sweep/in_parallel.hpp"
#include "fdebench/schemes/stepping/rates.hpp"

namespace fde::bench {

namespace {

// The runs of one scheme (with one grading) or program on a scene, from coarse to fine.
struct RefinementSeries {
  std::variant<const Scheme*, const ExternalProgram*> solver;
  RunKey key;                   // of the current run
  RunSettings setup{};          // of the current run; a program's key has fewer settings
  std::optional<Record> run{};  // the current run; nullopt: not examined
  bool ended = false;           // there is no current run
};

// A scene with all its runs. Examined by one thread.
struct SceneRefinements {
  SceneRefinements(SceneVariant swept, const Sweep& sweep)
      : variant(std::move(swept)), name(variant.key()), scene(make_scene(variant)) {
    for (const auto* scheme : sweep.schemes) {
      for (const RunSettings& setup : setups_of(sweep, *scheme, scene.problem)) {
        add({scheme, {name, std::string(scheme->id), setup}, setup}, scheme->capabilities, sweep.plan);
      }
    }
    for (const auto& program : sweep.programs) {
      add({&program, key_of(program, name, sweep.setup), sweep.setup}, Capabilities{}, sweep.plan);
    }
  }

  void add(RefinementSeries line, const Capabilities& capabilities, const SweepPlan& plan) {
    const auto same = [&](const RefinementSeries& other) {
      return other.solver == line.solver && other.setup == line.setup;
    };
    if (std::ranges::any_of(lines, same)) return;
    lines.push_back(std::move(line));
    listed.push_back(resolutions_for(plan, capabilities));
    refinements.push_back({.is_adaptive = capabilities.is_adaptive()});
  }

  SceneVariant variant;
  SceneSettings name;
  Scene scene;
  MemoizedReference reference{scene};
  std::vector<RefinementSeries> lines{};
  std::vector<std::vector<StepsOrTolerance>> listed{};  // one entry for each of `lines`
  std::vector<Refinement> refinements{};                // likewise
};

// Whether solutions are not smooth at 0: every row has a fractional order and belongs to no multi-term chain
// (whose first unknown is smooth).
bool starts_singular(const Problem& problem) {
  return problem.equations.empty() && std::ranges::none_of(problem.components, [](const auto& row) {
           return is_integer_order(row.order);
         });
}

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
bool is_timed_next(const RefinementSeries& line, const Sweep& sweep) {
  if (line.ended || sweep.examines_only) return false;
  if (!line.run->is_complete()) return true;
  return sweep.retimes && line.run->timing.is_disturbed() && line.run->timing.count < most_timings;
}

Record examine(SceneRefinements& of, const RefinementSeries& line) {
  if (const auto* program = std::get_if<const ExternalProgram*>(&line.solver))
    return examine(of.variant, of.scene, of.reference, **program, line.setup);
  return examine(of.name, of.scene, of.reference, *std::get<const Scheme*>(line.solver), line.setup);
}

// Times the current run. A program may fail then; its run is examined anew.
void time(const SceneRefinements& of, RefinementSeries& line, const TimingRepeats& repeats,
          GuardedCallbacks& log) {
  if (const auto* scheme = std::get_if<const Scheme*>(&line.solver)) {
    line.run->take(time_solves(of.scene, **scheme, line.setup, repeats));
  } else {
    time_runs(*line.run, of.variant, of.scene, *std::get<const ExternalProgram*>(line.solver), line.setup,
              repeats.most, repeats.enough_seconds);
  }
  line.run->timing.values.empty() ? log.append(*line.run) : log.append_times(*line.run);
}

void examine_runs(SceneRefinements& of, const Sweep& sweep, GuardedCallbacks& log) {
  for (RefinementSeries& line : of.lines) {
    if (log.failed()) return;
    if (line.ended || line.run) continue;
    log.on_event(SweepEvent::Kind::examines, line.key, !of.reference.is_begun());
    line.run = examine(of, line);
    if (!log.describes(of.name))
      log.append(describe(of.variant, of.scene, of.reference, sweep.describes_solutions));
    log.append(*line.run);
    if (sweep.examines_only || line.run->is_complete()) log.on_event(SweepEvent::Kind::is_done, line.key);
  }
}

void time_runs(SceneRefinements& of, const Sweep& sweep, GuardedCallbacks& log) {
  for (RefinementSeries& line : of.lines) {
    if (!is_timed_next(line, sweep)) continue;
    log.on_event(SweepEvent::Kind::times, line.key);
    time(of, line, sweep.repeats, log);
    log.on_event(SweepEvent::Kind::is_done, line.key);
  }
}

// Chooses the next run of each refinement of the scene. Returns whether there is any.
bool choose_next_runs(SceneRefinements& of, const SweepPlan& plan, const SweepCallbacks& callbacks,
                      GuardedCallbacks& log) {
  const auto next = next_runs(plan, of.listed, of.refinements);
  for (std::size_t i = 0; i < next.size(); ++i) {
    RefinementSeries& line = of.lines[i];
    if (!next[i] && !line.ended && !of.refinements[i].runs.empty())
      log.on_event(SweepEvent::Kind::refinement_ends, line.key);
    line.ended = !next[i];
    if (line.ended) continue;
    line.key.setup.resolution = line.setup.resolution = *next[i];
    line.run = callbacks.recorded(line.key);
  }
  return std::ranges::any_of(next, [](const auto& resolution) { return resolution.has_value(); });
}

void add_runs(SceneRefinements& of) {
  for (std::size_t i = 0; i < of.lines.size(); ++i) {
    if (!of.lines[i].ended) of.refinements[i].runs.push_back(refinement_run(*of.lines[i].run));
  }
}

// The forecast seconds of the scene's current runs.
double seconds_of_turn(const SceneRefinements& of, const Forecast& expected) {
  double seconds = 0.0;
  for (const RefinementSeries& line : of.lines) {
    const auto run = line.ended ? expected.end() : expected.find(line.key);
    if (run != expected.end()) seconds += run->second.total();
  }
  return seconds;
}

// Longest forecast first, so that the threads finish at about the same time.
std::vector<std::size_t> longest_first(const std::deque<SceneRefinements>& scenes, const Forecast& expected) {
  std::vector<double> seconds;
  for (const auto& of : scenes) seconds.push_back(seconds_of_turn(of, expected));
  std::vector<std::size_t> order(scenes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) { return seconds[i]; });
  return order;
}

// Makes the next run of every refinement. Returns whether there was any.
bool take_turn(std::deque<SceneRefinements>& scenes, const Sweep& sweep, const SweepCallbacks& callbacks,
               const Forecast& expected, GuardedCallbacks& log) {
  bool goes_on = false;
  for (auto& of : scenes) goes_on = choose_next_runs(of, sweep.plan, callbacks, log) || goes_on;
  const auto order = longest_first(scenes, expected);
  in_parallel(scenes.size(), sweep.threads,
              [&](std::size_t i) { examine_runs(scenes[order[i]], sweep, log); });
  for (auto& of : scenes) time_runs(of, sweep, log);
  for (auto& of : scenes) add_runs(of);
  return goes_on;
}

}  // namespace

std::vector<RunSettings> setups_of(const Sweep& sweep, const Scheme& scheme, const Problem& problem) {
  const bool graded =
      std::ranges::find(sweep.graded, &scheme) != sweep.graded.end() && starts_singular(problem);
  std::vector<RunSettings> setups{sweep.setup};
  if (!sweep.optimal_grids && !graded) return setups;
  RunSettings optimal = sweep.setup;
  optimal.grading = optimal_grading(scheme, problem);
  if (sweep.optimal_grids) return {optimal};
  if (optimal != sweep.setup) setups.push_back(optimal);
  return setups;
}

void run_sweep(const Sweep& requested, const SweepCallbacks& callbacks, const Forecast& expected) {
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
    std::deque<SceneRefinements> scenes;
    for (auto i = begin; i < std::min(begin + scenes_at_once, sweep.scenes.size()); ++i)
      scenes.emplace_back(sweep.scenes[i], sweep);
    while (take_turn(scenes, sweep, callbacks, expected, log)) {
    }
  }
}

}  // namespace fde::bench
