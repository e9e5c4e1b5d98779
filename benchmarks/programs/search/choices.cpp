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

namespace fde {
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
  Configuration way{};
  Attempt run{};
  double seconds = std::numeric_limits<double>::infinity();
};

// Makes a run and updates `best`. Returns whether finer runs of the configuration may still be quick enough.
bool try_one(RunEvaluator& examiner, const Configuration& way, const StepsOrTolerance& resolution,
             double most_seconds, Best& best) {
  constexpr int watched = 2048;
  const auto made = examiner.examine(way, resolution, watched, 10.0 * most_seconds + 1.0);
  if (made.seconds > 2.0 * most_seconds) return false;
  if (!made.within) return true;
  const auto time = time_interleaved({[&] { examiner.solve_for_timing(way, resolution); }}, 0.0);
  if (time.front().median < best.seconds) best = {way, made, time.front().median};
  return time.front().low <= most_seconds;
}

// Makes all runs of one configuration that take up to `most_seconds`.
void try_all(RunEvaluator& examiner, const Configuration& way, double most_seconds, Best& best) {
  constexpr double ratio = 1.1;
  const auto continues = [&](const StepsOrTolerance& resolution) {
    return try_one(examiner, way, resolution, most_seconds, best);
  };
  if (way.is_adaptive()) {
    for (double asked = 0.1; asked > 1e-14 && continues(Tolerance{asked, asked}); asked /= ratio) {
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
  if (first.found != Found::within) {
    fmt::print("{},{},{:g},none\n", label, error_measure(kind), accuracy);
    return;
  }
  RunEvaluator examiner(scene, question);
  Best best;
  for (const Scheme& scheme : schemes()) {
    if (!refusal(scheme, scene.problem, Tolerance{accuracy, accuracy}))
      try_all(examiner, {&scheme}, first.time->median, best);
    for (const double grading : gradings) {
      if (!refusal(scheme, scene.problem, Grid{scene.problem.end, 4, grading}))
        try_all(examiner, {&scheme, grading}, first.time->median, best);
    }
  }
  double ratio = 0.0;
  if (best.run.within) {
    const auto times =
        time_interleaved({[&] { examiner.solve_for_timing(first.way, resolution_of(first.best)); },
                          [&] { examiner.solve_for_timing(best.way, resolution_of(best.run)); }},
                         1.0);
    ratio = times[0].median / times[1].median;
  }
  fmt::print("{},{},{:g},{},{},{},{:.3g},{:.3g},{},{},{},{:.2f}\n", label, error_measure(kind), accuracy,
             first.way.scheme->id, first.way.grading, first.best.steps, first.best.error, first.time->median,
             best.run.within ? best.way.scheme->id : "none", best.way.grading, best.run.steps, ratio);
  std::fflush(stdout);
}

}  // namespace
}  // namespace fde

int main(int count, char** words) try {
  fmt::print("scene,error,accuracy,scheme,grading,steps,verified,seconds,best,its_grading,its_steps,ratio\n");
  const std::vector<const char*> asked(words + 1, words + count);
  for (const auto* scene :
       asked.empty() ? std::vector(fde::scenes_of_all.begin(), fde::scenes_of_all.end()) : asked) {
    for (const auto norm : {fde::Norm::maximum, fde::Norm::end}) {
      for (const double accuracy : fde::accuracies) fde::compare(scene, {norm, fde::Scale::mixed}, accuracy);
    }
  }
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 1;
}
