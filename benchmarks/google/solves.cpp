// solve/<scene>/<scheme>/<N> for every pair of the lists that fits, with the error of the solution beside
// each time.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <list>

#include "experiment.hpp"

namespace {

using namespace fde;

// A scene with its truth, which is made once, when the first benchmark of the scene needs it.
struct Subject {
  explicit Subject(const SceneMaker& maker) : scene(make_scene(maker)) {}
  Scene scene;
  TruthTable truth{scene};
};

void solve(benchmark::State& state, Subject& subject, const Scheme& scheme, int steps) {
  const Grid grid{.end = subject.scene.problem.end, .steps = steps};
  Trajectory path;
  for (auto _ : state) path = scheme.solve(subject.scene.problem, grid, {.keep = {steps}});
  if (path.outcome != Outcome::finished) {
    state.SkipWithError(describe(path).c_str());
    return;
  }
  const Rows error = shown(subject.scene, path.y) - subject.truth.at(grid, path.steps);
  state.counters["error"] = error.cwiseAbs().maxCoeff();
}

}  // namespace

int main(int count, char** arguments) {
  std::list<Subject> subjects;  // stay where they are
  for (const auto& maker : scenes()) {
    auto& subject = subjects.emplace_back(maker);
    for (const auto& scheme : schemes()) {
      for (const int steps : {256, 1024, 4096}) {
        if (refusal(scheme, subject.scene.problem, {subject.scene.problem.end, steps})) continue;
        benchmark::RegisterBenchmark(
            fmt::format("solve/{}/{}/{}", maker.id, scheme.id, steps).c_str(),
            [&subject, &scheme, steps](benchmark::State& state) { solve(state, subject, scheme, steps); })
            ->Unit(benchmark::kMillisecond);
      }
    }
  }
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
