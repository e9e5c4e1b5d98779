// SPDX-License-Identifier: MIT
// choices [SCENE...]: compares the recommendation of `choose` with all runs of all schemes, numbers of steps
// in a ratio of 1.1, on five gradings. Prints CSV: the recommendation, the quickest of these runs within the
// accuracy, and the ratio of their times, measured interleaved.

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <exception>

#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/search/interleaved_times.hpp"
#include "fdebench/benchmarks/search/search.hpp"

namespace fde::bench {
namespace {

constexpr std::array scenes_of_all{"relaxation",
                                   "relaxation:gamma=1.5",
                                   "relaxation_pair",
                                   "stiff_relaxation",
                                   "power",
                                   "diethelm",
                                   "linear_system",
                                   "fractional_oscillator",
                                   "bagley_torvik:load=0,y0=1",
                                   "damped_oscillator",
                                   "brusselator",
                                   "pendulum:until=5"};
constexpr std::array accuracies{1e-2, 1e-4, 1e-6, 1e-8};
constexpr std::array gradings{1.0, 1.5, 2.0, 3.0, 4.0};

struct Best {
  Configuration configuration{};
  CandidateRun run{};
  double seconds = std::numeric_limits<double>::infinity();
};

// Makes a run and updates `best`. Returns whether finer runs of the configuration may still be quick enough.
bool try_one(RunEvaluator& evaluator, const Configuration& configuration, const StepsOrTolerance& resolution,
             double most_seconds, Best& best) {
  constexpr int compared = 2048;
  const auto made = evaluator.evaluate(configuration, resolution, compared, 10.0 * most_seconds + 1.0);
  if (made.seconds > 2.0 * most_seconds) return false;
  if (!made.meets_accuracy) return true;
  const auto time = time_interleaved({[&] { evaluator.solve_for_timing(configuration, resolution); }}, 0.0);
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

void compare(const char* label, const ErrorKind& kind, double accuracy) {
  const Scene scene = make_scene(parse_variant(label));
  const AccuracyTarget question{kind, accuracy, all_columns(scene)};
  const auto found = search(scene, question, 60.0, [](const std::string&, double) {});
  const SearchCandidate& first = found.front();
  if (first.outcome != SearchOutcome::accuracy_reached) {
    fmt::print("{},{},{:g},none\n", label, error_measure(kind), accuracy);
    return;
  }
  RunEvaluator evaluator(scene, question);
  Best best;
  for (const Scheme& scheme : schemes()) {
    if (!unsupported_reason(scheme, scene.problem, Tolerance{accuracy, accuracy}))
      try_all(evaluator, {&scheme}, first.time->median, best);
    for (const double grading : gradings) {
      if (!unsupported_reason(scheme, scene.problem, Grid{scene.problem.end, 4, grading}))
        try_all(evaluator, {&scheme, grading}, first.time->median, best);
    }
  }
  double ratio = 0.0;
  if (best.run.meets_accuracy) {
    const auto times =
        time_interleaved({[&] { evaluator.solve_for_timing(first.configuration, resolution_of(first.best)); },
                          [&] { evaluator.solve_for_timing(best.configuration, resolution_of(best.run)); }},
                         1.0);
    ratio = times[0].median / times[1].median;
  }
  fmt::print("{},{},{:g},{},{},{},{:.3g},{:.3g},{},{},{},{:.2f}\n", label, error_measure(kind), accuracy,
             first.configuration.scheme->id, first.configuration.grading, first.best.steps, first.best.error,
             first.time->median, best.run.meets_accuracy ? best.configuration.scheme->id : "none",
             best.configuration.grading, best.run.steps, ratio);
  std::fflush(stdout);
}

}  // namespace
}  // namespace fde::bench

int main(int count, char** words) try {
  fmt::print("scene,error,accuracy,scheme,grading,steps,verified,seconds,best,its_grading,its_steps,ratio\n");
  const std::vector<const char*> requested(words + 1, words + count);
  for (const auto* scene :
       requested.empty() ? std::vector(fde::bench::scenes_of_all.begin(), fde::bench::scenes_of_all.end())
                         : requested) {
    for (const auto norm : {fde::Norm::maximum, fde::Norm::end}) {
      for (const double accuracy : fde::bench::accuracies)
        fde::bench::compare(scene, {norm, fde::bench::Scale::mixed}, accuracy);
    }
  }
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 1;
}
