// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/measured_run.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "fdebench/benchmarks/measures/judge.hpp"
#include "fdebench/benchmarks/measures/rounding.hpp"
#include "fdebench/benchmarks/measures/timing_conditions.hpp"
#include "fdebench/benchmarks/measures/total_variation.hpp"
#include "fdebench/benchmarks/observers/comparison_steps.hpp"
#include "fdebench/benchmarks/observers/drift.hpp"
#include "fdebench/benchmarks/observers/retained_columns.hpp"
#include "fdebench/schemes/stepping/rates.hpp"
#include "fdebench/schemes/stepping/setup_time.hpp"

namespace fde::bench {

namespace {

// The observers of a scene: energy balance and drift from the constraint. Called after every step.
class Observers {
 public:
  Observers(const Scene& scene, const std::optional<Grid>& grid) : scene_(scene) {
    if (scene.energy.power) energy_.emplace(scene.energy);
    if (scene.constraint) drift_.emplace(scene, grid);
  }

  [[nodiscard]] bool empty() const { return !energy_ && !drift_; }

  void observe(double t, In y) {
    const Vec columns = columns_at(scene_.outputs, t, y);
    if (energy_) energy_->observe(t, columns);
    if (drift_) drift_->observe(t, columns);
  }

  void store_results(RunObservations& observed) const {
    if (energy_) observed.energy_residual = energy_->residual();
    if (!drift_) return;
    observed.internal_drift = drift_->internal();
    observed.independent_drift = drift_->independent();
  }

 private:
  const Scene& scene_;
  std::optional<EnergyObserver> energy_{};
  std::optional<DriftObserver> drift_{};
};

// A run and its columns at path.times. A run on a grid stores only these columns and the last state.
struct RunWithColumns {
  Trajectory path;
  Rows columns;
};

RunWithColumns solve_shown(const Scene& scene, const Scheme& scheme, const Problem& problem,
                           const Resolution& resolution, const Options& options, double unit) {
  if (!std::holds_alternative<Grid>(resolution)) {
    RunWithColumns run{scheme.solve(problem, resolution, options), {}};
    run.path.y *= unit;
    run.columns = columns_of(scene.outputs, run.path);
    return run;
  }
  RetainedColumns kept(scene.outputs, options.output_times, unit);
  Options observed = options;
  observed.output_times = {problem.end};
  observed.observer = [&](double t, In y) {
    if (options.observer) options.observer(t, y);
    kept.observe(t, y);
  };
  RunWithColumns run{scheme.solve(problem, resolution, observed), {}};
  run.path.times = kept.times();
  run.columns = kept.columns();
  return run;
}

// The columns of the run repeated in other units, whose rounding errors differ; empty if it takes other
// steps.
Rows rounded_otherwise(const Scene& scene, const Scheme& scheme, const Resolution& resolution,
                       const Options& options, const Trajectory& path) {
  constexpr double unit = 0.7;
  const auto run =
      solve_shown(scene, scheme, rescaled_problem(unit, scene.problem), resolution, options, unit);
  const auto& other = run.path;
  if (other.status != SolveStatus::finished || other.steps != path.steps || other.times != path.times)
    return {};
  return run.columns;
}

void tell_rates(const Scene& scene, const Scheme& scheme, const Grid& grid, RunObservations& observed) {
  const auto rate = [&](Norm norm) {
    return theoretical_rate(scheme, scene.problem, scene.smoothness, grid, norm);
  };
  observed.expected_rate_end = rate(Norm::end);
  observed.expected_rate_maximum = rate(Norm::maximum);
}

// The times of some steps of an adaptive run: between times that are the same for all runs an error may be
// larger. A step next to an event at which y jumps is as far off as y jumps, whatever the error of its time.
std::vector<double> own_times(const Scene& scene, const Scheme& scheme, const Resolution& resolution,
                              Options options) {
  constexpr int most = 256;
  std::vector<double> taken, some;
  if (!scene.problem.resets.empty()) return some;
  options.output_times = {scene.problem.end};
  options.observer = [&](double t, In) { taken.push_back(t); };
  scheme.solve(scene.problem, resolution, options);
  if (taken.empty()) return some;
  for (const int step : comparison_steps(static_cast<int>(taken.size()) - 1, most))
    some.push_back(std::min(taken[static_cast<std::size_t>(step)], scene.problem.end));
  return some;
}

// The times at which a run is compared with the reference.
std::vector<double> times_to_compare(const Scene& scene, const Scheme& scheme, const Resolution& resolution,
                                     const Options& options) {
  if (const auto* grid = std::get_if<Grid>(&resolution))
    return comparison_times(*grid, comparison_steps_for(scene.outputs.names.size()));
  auto times = comparison_times(scene.problem);
  std::ranges::copy(own_times(scene, scheme, resolution, options), std::back_inserter(times));
  return increasing(std::move(times));
}

// The steps of a run and its measures.
struct Examined {
  std::int64_t steps = 0;
  Assessment judgement{};
};

Examined solve_and_judge(const Scene& scene, MemoizedReference& reference, const Scheme& scheme,
                         const RunSettings& settings, std::span<const OwnMeasure> own) {
  const Resolution resolution = resolution_of(settings, scene.problem.end);
  if (auto reason = unsupported_reason(scheme, scene.problem, resolution))
    return {.judgement = {{SolveStatus::refused, std::move(*reason)}}};
  RunObservations observed{.own = own};
  if (const auto* grid = std::get_if<Grid>(&resolution)) observed.grid = *grid;
  Options options = settings.options();
  options.output_times = times_to_compare(scene, scheme, resolution, options);
  Options observing = options;
  Observers observers(scene, observed.grid);
  if (!observers.empty()) observing.observer = [&](double t, In y) { observers.observe(t, y); };
  auto [path, columns] = solve_shown(scene, scheme, scene.problem, resolution, observing, 1.0);
  if (!scheme.capabilities.implicit) path.cost.newton_iterations.reset();  // an explicit scheme has none
  if (path.status == SolveStatus::finished) {
    observed.rounded = rounded_otherwise(scene, scheme, resolution, options, path);
    observers.store_results(observed);
    if (observed.grid) {
      tell_rates(scene, scheme, *observed.grid, observed);
      observed.unresolved = unresolved_variations(scene.problem, reference, *observed.grid);
    }
  }
  return {path.steps, judge(scene, path, columns, reference, observed)};
}

TimedSolves solve_repeatedly(const Scheme& scheme, const Problem& problem, const Resolution& resolution,
                             const Options& options, const TimingRepeats& repeats) {
  TimedSolves timed;
  auto& seconds = timed.seconds;
  const TimingWatch watch;
  double total = 0.0;
  while (total < repeats.min_seconds ||
         (std::ssize(seconds) < repeats.most && total < repeats.enough_seconds)) {
    const SetupTime setup;
    const double ran_before = thread_seconds();
    const auto start = std::chrono::steady_clock::now();
    scheme.solve(problem, resolution, options);
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    timed.waited.push_back(std::max(0.0, seconds.back() - (thread_seconds() - ran_before)));
    timed.setup_seconds = setup.seconds();
    total += seconds.back();
  }
  timed.conditions = watch.conditions();
  return timed;
}

}  // namespace

RunKey key_of(const Scheme& scheme, const SceneSettings& scene, const RunSettings& settings) {
  return {.scene = scene,
          .scheme = std::string(scheme.id),
          .settings = settings,
          .external = find_scheme(scheme.id) != &scheme};
}

// Over a grid the steps are the requested ones, also if the run stopped earlier.
Record examine(const SceneSettings& name, const Scene& scene, MemoizedReference& reference,
               const Scheme& scheme, const RunSettings& settings, std::span<const OwnMeasure> own) {
  const auto [steps, judgement] = solve_and_judge(scene, reference, scheme, settings, own);
  const auto* requested = std::get_if<int>(&settings.resolution);
  return assessed({.key = key_of(scheme, name, settings),
                   .steps = requested != nullptr ? *requested : static_cast<int>(steps),
                   .end = scene.problem.end},
                  judgement);
}

Timing time_solves(const Scene& scene, const Scheme& scheme, const RunSettings& settings,
                   const TimingRepeats& repeats) {
  Options options = settings.options();
  options.budget = std::numeric_limits<double>::infinity();  // the examined run has finished
  options.output_times = {scene.problem.end};
  const auto resolution = resolution_of(settings, scene.problem.end);
  TimedSolves timed;
  for (int attempt = 0; attempt < repeats.attempts && (attempt == 0 || is_disturbed(timed)); ++attempt)
    timed = solve_repeatedly(scheme, scene.problem, resolution, options, repeats);
  return timing_of(timed);
}

}  // namespace fde::bench
