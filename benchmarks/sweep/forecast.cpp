// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/forecast.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/observers/comparison_steps.hpp"
#include "fdebench/benchmarks/sweep/in_parallel.hpp"
#include "fdebench/benchmarks/sweep/probe_choice.hpp"
#include "fdebench/benchmarks/sweep/scene_refinements.hpp"
#include "fdebench/schemes/stepping/rates.hpp"

namespace fde::bench {
namespace {

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Times and errors of two or three solves of one scheme on one scene, extrapolated to other resolutions: by
// what a further step takes, not by the whole time, most of which may be the same for any number of steps.
class Probe {
 public:
  Probe(const Scene& scene, const Scheme& scheme, const RunSettings& settings, const SweepPlan& plan)
      : budget_(settings.budget), is_adaptive_(scheme.capabilities.is_adaptive()) {
    take_refusals(scene, scheme, settings, plan);
    is_adaptive_ ? probe_accuracy(scene, scheme, settings) : probe_steps(scene, scheme, settings, plan);
  }

  // The predicted run with this number of steps or tolerance.
  [[nodiscard]] RefinementRun forecast(const StepsOrTolerance& resolution) const {
    const auto* steps = std::get_if<int>(&resolution);
    RefinementRun run{.resolution = resolution, .steps = steps != nullptr ? *steps : 0};
    run.fails_with_more_steps = !refusal(resolution).empty();
    if (run.fails_with_more_steps) return run;
    if (is_long_) run.seconds = budget_;
    if (fine_.failed) return run;
    run.seconds = std::min(
        steps != nullptr ? seconds_with(*steps) : seconds_to(std::get<Tolerance>(resolution)), budget_);
    if (steps == nullptr) return run;
    for (const auto& rate : {end_rate_, maximum_rate_})
      run.errors.push_back({.value = error_ * std::pow(fine_.steps / *steps, rate.value_or(1.0))});
    return run;
  }

  // Why the scheme refuses a run; empty: it does not.
  [[nodiscard]] std::string refusal(const StepsOrTolerance& resolution) const {
    const auto found = refusals_.find(resolution);
    return found == refusals_.end() ? refusal_ : found->second;
  }

 private:
  struct Solve {
    double steps = 0.0, seconds = 0.0;
    Vec at_end{};  // the columns
    bool failed = true;
  };

  // Of each listed resolution; of others that of one of the kind that the scheme takes.
  void take_refusals(const Scene& scene, const Scheme& scheme, const RunSettings& settings,
                     const SweepPlan& plan) {
    const auto reason = [&](const StepsOrTolerance& requested) {
      RunSettings of = settings;
      of.resolution = requested;
      return unsupported_reason(scheme, scene.problem, resolution_of(of, scene.problem.end)).value_or("");
    };
    refusal_ = is_adaptive_ ? reason(Tolerance{finest, finest}) : reason(fewest_steps(plan));
    for (const auto& resolution : plan.resolutions) refusals_[resolution] = reason(resolution);
  }

  // The finest solve has four times these steps: at most 512, and a quarter of the largest number of the
  // plan.
  static int fewest_steps(const SweepPlan& plan) {
    constexpr int most = 128, part = 16;
    int steps = plan.goal ? plan.goal->most_steps : 0;
    for (const auto& resolution : plan.resolutions) {
      if (const auto* some = std::get_if<int>(&resolution)) steps = std::max(steps, *some);
    }
    return std::clamp(steps / part, 1, most);
  }

  void probe_steps(const Scene& scene, const Scheme& scheme, const RunSettings& settings,
                   const SweepPlan& plan) {
    const int fewest = fewest_steps(plan);
    coarse_ = solve(scene, scheme, settings, fewest);
    const Solve between = coarse_.failed ? Solve{} : solve(scene, scheme, settings, 2 * fewest);
    if (between.failed) return;
    fine_ = solve(scene, scheme, settings, 4 * fewest);
    if (fine_.failed) return;
    error_ = (fine_.at_end - between.at_end).cwiseAbs().maxCoeff();
    const Grid grid{scene.problem.end, 4 * fewest, settings.grading};
    end_rate_ = theoretical_rate(scheme, scene.problem, scene.smoothness, grid, Norm::end);
    maximum_rate_ = theoretical_rate(scheme, scene.problem, scene.smoothness, grid, Norm::maximum);
  }

  void probe_accuracy(const Scene& scene, const Scheme& scheme, const RunSettings& settings) {
    coarse_ = solve(scene, scheme, settings, Tolerance{coarsest, coarsest});
    if (!coarse_.failed) fine_ = solve(scene, scheme, settings, Tolerance{finest, finest});
  }

  [[nodiscard]] double seconds_with(double steps) const {
    const double more = std::max(0.0, fine_.seconds - coarse_.seconds) / (fine_.steps - coarse_.steps);
    return steps <= fine_.steps ? fine_.seconds * steps / fine_.steps
                                : fine_.seconds + more * (steps - fine_.steps);
  }

  // A scheme of rate r takes 10^(1/r) times the steps for a tolerance ten times smaller.
  [[nodiscard]] double seconds_to(const Tolerance& requested) const {
    const double decades = std::log10(finest / std::max(requested.rtol, requested.atol));
    const double growth = std::pow(fine_.steps / coarse_.steps, 1.0 / std::log10(coarsest / finest));
    return fine_.seconds * std::pow(std::clamp(growth, 1.0, most_growth), decades);
  }

  // Short solves are timed a second time: the first one of a process also computes tables.
  [[nodiscard]] Solve solve(const Scene& scene, const Scheme& scheme, RunSettings settings,
                            const StepsOrTolerance& requested) {
    constexpr double most_seconds = 0.25, short_seconds = 0.02;
    settings.resolution = requested;
    settings.budget = std::min(settings.budget, most_seconds);
    const double end = scene.problem.end;
    if (!refusal_.empty()) return {};
    Options options = settings.options();
    options.output_times = {end};
    Trajectory path;
    const auto once = [&] {
      return seconds_of([&] { path = scheme.solve(scene.problem, resolution_of(settings, end), options); });
    };
    double seconds = once();
    is_long_ = path.status == SolveStatus::out_of_budget;
    if (path.status != SolveStatus::finished) return {};
    if (seconds < short_seconds) seconds = std::min(seconds, once());
    return {.steps = std::max(1.0, static_cast<double>(path.steps)),
            .seconds = seconds,
            .at_end = columns_at(scene.outputs, end, path.y.rightCols(1)),
            .failed = false};
  }

  static constexpr double coarsest = 1e-3, finest = 1e-5, most_growth = 10.0;

  double budget_;  // seconds, of a solve; two short solves may foretell more by far
  bool is_adaptive_;
  std::map<StepsOrTolerance, std::string> refusals_{};
  std::string refusal_{};
  Solve coarse_{}, fine_{};
  bool is_long_ = false;  // the last solve ran out of its budget
  double error_ = 0.0;    // of fine_
  std::optional<double> end_rate_{}, maximum_rate_{};
};

// Seconds to evaluate the reference of a scene at one time.
double seconds_of_reference(const Scene& scene) {
  constexpr double enough_seconds = 0.05;
  if (!scene.reference.at) return 0.0;
  try {
    scene.reference.at(scene.problem.end);  // computes what later evaluations reuse
    double seconds = 0.0;
    int times = 0;
    for (const double part : {0.7, 0.1, 0.4, 0.9}) {
      seconds += seconds_of([&] { scene.reference.at(part * scene.problem.end); });
      ++times;
      if (seconds > enough_seconds) break;
    }
    return seconds / times;
  } catch (const std::runtime_error&) {
    return 0.0;
  }
}

// The seconds of the timed solves of a run; 0 if it is not timed.
double seconds_of_timing(const RefinementRun& run, const TimingRepeats& repeats) {
  if (!run.seconds) return 0.0;
  const double once = *run.seconds;
  const double wanted = std::min(repeats.most * once, repeats.enough_seconds + once);
  return std::max({wanted, once, repeats.min_seconds});
}

// The settings of a scheme on a scene, and its probe there.
struct ProbedLine {
  const Scheme* scheme;
  Probe probe;
};

// What is measured of a scene: its schemes, and the seconds of its reference at one time.
struct ProbedScene {
  ProbedScene(const SceneVariant& variant, const Sweep& sweep) {
    const Scene scene = make_scene(variant);
    has_solution = scene.reference.at != nullptr;
    reference = seconds_of_reference(scene);
    for (const auto* scheme : sweep.schemes) {
      for (const RunSettings& settings : settings_of(sweep, *scheme, &scene.problem))
        lines.push_back({scheme, Probe(scene, *scheme, settings, sweep.plan)});
    }
  }

  // The probe of the scheme with its settings of this number, or its last.
  [[nodiscard]] const Probe& probe(const Scheme* scheme, std::size_t number) const {
    const auto first = std::ranges::find(lines, scheme, &ProbedLine::scheme);
    const auto count = static_cast<std::size_t>(std::ranges::count(lines, scheme, &ProbedLine::scheme));
    return (first + static_cast<std::ptrdiff_t>(std::min(number, count - 1)))->probe;
  }

  bool has_solution = false;  // the reference is not computed by two methods
  double reference = 0.0;
  std::vector<ProbedLine> lines{};
};

// Simulates the refinement of all schemes on one scene, from what is measured of a scene like it.
class RefinementSimulation {
 public:
  RefinementSimulation(const SceneVariant& variant, const ProbedScene& probed, const Sweep& sweep,
                       const RecordedLookup& recorded)
      : name_(variant.key()), variant_(variant), probed_(probed), sweep_(sweep), recorded_(recorded) {}

  // A scene is made only where the settings depend on it.
  Forecast simulate() {
    std::optional<Scene> scene;
    if (sweep_.optimal_grids || !sweep_.graded.empty()) scene = make_scene(variant_);
    SceneRefinements refinements(sweep_, name_, scene ? &scene->problem : nullptr);
    while (refinements.choose_next(sweep_.plan)) {
      const Scheme* last = nullptr;
      std::size_t number = 0;  // of the series of this scheme
      for (std::size_t i = 0; i < refinements.series.size(); ++i) {
        const RefinementSeries& line = refinements.series[i];
        const auto* const* scheme = std::get_if<const Scheme*>(&line.solver);
        number = scheme != nullptr && *scheme == last ? number + 1 : 0;
        if (scheme != nullptr) last = *scheme;
        if (!line.is_due) continue;
        refinements.add(i, scheme != nullptr ? take(line, probed_.probe(*scheme, number)) : take(line));
      }
    }
    return std::move(expected_);
  }

 private:
  // The recorded run; nullopt if it is to be made.
  [[nodiscard]] std::optional<RefinementRun> made(const RefinementSeries& line) const {
    const auto run = recorded_(line.key);
    const bool is_made = run && (run->is_complete() || sweep_.examines_only);
    return is_made ? std::optional(refinement_run(*run)) : std::nullopt;
  }

  RefinementRun take(const RefinementSeries& line, const Probe& probe) {
    if (const auto run = made(line)) return *run;
    const auto& resolution = line.settings.resolution;
    RefinementRun run = probe.forecast(resolution);
    expected_[line.key] = {seconds_of(run),
                           sweep_.examines_only ? 0.0 : seconds_of_timing(run, sweep_.repeats),
                           probe.refusal(resolution)};
    return run;
  }

  // Programs are not started for a forecast: one second per run is assumed.
  RefinementRun take(const RefinementSeries& line) {
    constexpr double guess = 1.0;
    if (const auto run = made(line)) return *run;
    expected_[line.key] = {guess, sweep_.examines_only ? 0.0 : guess * sweep_.repeats.most, ""};
    const auto& resolution = line.settings.resolution;
    return {.resolution = resolution, .steps = std::get<int>(resolution)};
  }

  // The seconds of an examination, divided by the number of scenes in parallel: its two solves and the
  // reference at times not evaluated before.
  double seconds_of(const RefinementRun& run) {
    constexpr double least = 0.002, computed_reference = 0.5;
    double seconds = least + 2.0 * run.seconds.value_or(0.0);
    const int times = run.seconds ? std::min(run.steps, max_comparison_steps) : 0;
    if (times > 0 && known_ == 0 && !probed_.has_solution) seconds += computed_reference;
    seconds += probed_.reference * std::max(0, times - known_);
    known_ = std::max(known_, times);
    const auto side_by_side = std::min<std::size_t>(std::max(1U, sweep_.threads), sweep_.scenes.size());
    return seconds / static_cast<double>(side_by_side);
  }

  SceneSettings name_;
  const SceneVariant& variant_;
  const ProbedScene& probed_;
  const Sweep& sweep_;
  const RecordedLookup& recorded_;
  int known_ = 0;  // number of times at which the reference has been evaluated
  Forecast expected_{};
};

}  // namespace

double total_seconds(const Forecast& forecast) {
  return std::accumulate(forecast.begin(), forecast.end(), 0.0,
                         [](double sum, const auto& run) { return sum + run.second.total(); });
}

Forecast forecast(const Sweep& sweep, const RecordedLookup& recorded) {
  const auto choice = choose_probes(sweep.scenes);
  std::vector<std::optional<ProbedScene>> probed(choice.probed.size());
  in_parallel(probed.size(), sweep.threads,
              [&](std::size_t i) { probed[i].emplace(sweep.scenes[choice.probed[i]], sweep); });
  Forecast all;
  for (std::size_t i = 0; i < sweep.scenes.size(); ++i)
    all.merge(RefinementSimulation(sweep.scenes[i], *probed[choice.of[i]], sweep, recorded).simulate());
  return all;
}

}  // namespace fde::bench
