// SPDX-License-Identifier: MIT
// choices SEED COUNT: asks `choose` COUNT random questions over the default scenes and compares each answer
// with all runs of all schemes that take no longer, numbers of steps in a ratio of 1.1 on five gradings and
// tolerances likewise. Prints CSV: what is wanted, the answer, the quickest of these runs within the
// accuracy, the ratio of their times, measured interleaved, and the seconds of the search.

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "fdebench/benchmarks/programs/figures.hpp"
#include "fdebench/benchmarks/references/memoized_reference.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/search/estimated_reference.hpp"
#include "fdebench/benchmarks/search/interleaved_times.hpp"
#include "fdebench/benchmarks/search/run_evaluator.hpp"
#include "fdebench/benchmarks/search/search.hpp"
#include "fdebench/benchmarks/sweep/default_sweep.hpp"

namespace fde::bench::figures {
namespace {

constexpr std::array gradings{1.0, 1.5, 2.0, 3.0, 4.0};

struct Best {
  Configuration configuration{};
  RefinementRun run{};
  double seconds = std::numeric_limits<double>::infinity();
};

// Makes a run and updates `best`. Returns whether finer runs of the configuration may still be quick enough.
bool try_one(RunEvaluator& evaluator, const Configuration& configuration, const StepsOrTolerance& resolution,
             double most_seconds, Best& best) {
  constexpr int compared = 2048;
  const auto made = evaluator.evaluate(configuration, resolution, compared, 10.0 * most_seconds + 1.0);
  if (*made.seconds > 2.0 * most_seconds) return false;
  if (!evaluator.is_accurate(made)) return true;
  const auto time = time_interleaved({{[&] { evaluator.solve_for_timing(configuration, resolution); }}}, 0.0);
  if (time.front().median < best.seconds) best = {configuration, made, time.front().median};
  return time.front().low <= most_seconds;
}

// Makes all runs of one configuration that take up to `most_seconds`.
void try_all(RunEvaluator& evaluator, const Configuration& configuration, double most_seconds, Best& best) {
  constexpr double ratio = 1.1;
  const auto continues = [&](const StepsOrTolerance& resolution) {
    return try_one(evaluator, configuration, resolution, most_seconds, best);
  };
  if (configuration.is_adaptive()) {
    for (double tolerance = 0.1; tolerance > 1e-14 && continues(Tolerance{tolerance, tolerance});
         tolerance /= ratio) {
    }
    return;
  }
  for (double steps = 4.0; steps < 1e8; steps = std::max(steps + 1.0, std::floor(ratio * steps))) {
    if (!continues(static_cast<int>(steps))) return;
  }
}

struct Task {
  SceneVariant scene;
  ErrorKind kind;
  double accuracy;
};

Task random_task(std::mt19937_64& random) {
  const auto scenes = default_scenes();
  const auto pick = [&](std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
  };
  const double exponent = std::uniform_real_distribution<double>(-12.0, -2.0)(random);
  constexpr std::array norms{Norm::maximum, Norm::end};
  constexpr std::array scales{Scale::mixed, Scale::absolute, Scale::relative};
  return {scenes[pick(scenes.size())],
          {norms.at(pick(2)), scales.at(pick(3))},
          std::stod(fmt::format("{:.1e}", std::pow(10.0, exponent)))};
}

Best best_of_all(const Scene& scene, const AccuracyTarget& target, double most_seconds) {
  RunEvaluator evaluator(scene, target);
  Best best;
  for (const Scheme& scheme : schemes()) {
    if (!unsupported_reason(scheme, scene.problem, Tolerance{target.accuracy, target.accuracy}))
      try_all(evaluator, {&scheme}, most_seconds, best);
    for (const double grading : gradings) {
      if (!unsupported_reason(scheme, scene.problem, Grid{scene.problem.end, 4, grading}))
        try_all(evaluator, {&scheme, grading}, most_seconds, best);
    }
  }
  return best;
}

void compare(const Task& task) {
  Scene scene = make_scene(task.scene);
  const AccuracyTarget target{task.kind, task.accuracy, all_columns(scene)};
  fmt::print("\"{}\",{},{:g},", task.scene.label(), error_measure(task.kind), task.accuracy);
  std::vector<SearchCandidate> found;
  const auto start = std::chrono::steady_clock::now();
  try {
    scene.reference = reference_of(scene);
    found = search(scene, target, 60.0, [](const std::string&, double) {});
  } catch (const std::runtime_error& none) {
    fmt::print("\"{}\"\n", none.what());
    return;
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  const SearchCandidate& first = found.front();
  if (first.outcome != SearchOutcome::accuracy_reached) {
    fmt::print("none,,,,,,,,,{:.2f}\n", taken.count());
    return;
  }
  RunEvaluator evaluator(scene, target);
  const Best best = best_of_all(scene, target, first.time->median);
  double ratio = 0.0;
  const bool is_found = best.configuration.scheme != nullptr;
  if (is_found) {
    const auto times =
        time_interleaved({{[&] { evaluator.solve_for_timing(first.configuration, first.best.resolution); }},
                          {[&] { evaluator.solve_for_timing(best.configuration, best.run.resolution); }}},
                         0.5);
    ratio = times[0].median / times[1].median;
  }
  fmt::print("{},{},{},{:.3g},{:.3g},{},{},{},{:.2f},{:.2f}\n", first.configuration.scheme->id,
             first.configuration.grading, first.best.steps, first.best.error().value / task.accuracy,
             first.time->median, is_found ? best.configuration.scheme->id : "none",
             best.configuration.grading, best.run.steps, ratio, taken.count());
}

}  // namespace

void choices(const Words& given) {
  std::mt19937_64 random(given.empty() ? 1 : std::stoull(given[0]));
  const int questions = given.size() < 2 ? 40 : std::stoi(given[1]);
  fmt::print(
      "scene,kind,accuracy,scheme,grading,steps,part_of_accuracy,seconds,best,its_grading,its_steps,ratio,"
      "search_seconds\n");
  for (int i = 0; i < questions; ++i) {
    compare(random_task(random));
    std::fflush(stdout);
  }
}

}  // namespace fde::bench::figures
