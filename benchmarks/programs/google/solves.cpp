// SPDX-License-Identifier: MIT
// solve/<scene>/<scheme>/<N> for every scene and every scheme that accepts it: time, error of the solution
// and Newton iterations. history/<scene>/<scheme>/<engine>/<N> compares the history engines on whole solves.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <list>

#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"

namespace {

using namespace fde;
using namespace fde::bench;

// A scene with its reference, which is computed once, by the first benchmark of the scene.
struct Subject {
  explicit Subject(const SceneFactory& maker) : id(maker.id), scene(make_scene(maker)) {}
  std::string_view id;
  Scene scene;
  MemoizedReference reference{scene};
};

void solve(benchmark::State& state, Subject& subject, const Scheme& scheme, int steps,
           HistoryKind history = HistoryKind::automatic) {
  const Grid grid{.end = subject.scene.problem.end, .steps = steps};
  const Options options{.history = history, .output_times = {grid.end}};
  Trajectory path;
  for (auto _ : state) path = scheme.solve(subject.scene.problem, grid, options);
  if (path.status != SolveStatus::finished) {
    state.SkipWithError(describe(subject.scene.problem, path).c_str());
    return;
  }
  const Rows error = columns_of(subject.scene.outputs, path) - subject.reference.at(path.times);
  state.counters["error"] = error.cwiseAbs().maxCoeff();
  if (scheme.capabilities.implicit) {
    state.counters["iterations_per_step"] =
        static_cast<double>(path.cost.newton_iterations.value_or(0)) / static_cast<double>(path.steps);
  }
  state.counters["per_step"] =
      benchmark::Counter(steps, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// A run of diffusion on a line of a million points: time for each unknown and step.
void many_unknowns(benchmark::State& state, int threads) {
  const auto& makers = built_in_scenes();
  const auto maker = std::ranges::find(makers, "fractional_diffusion", &SceneFactory::id);
  constexpr double unknowns = 1e6;
  constexpr int steps = 200;
  const Scene scene = make_scene(*maker, {{"components", unknowns}});
  const Options options{.threads = threads, .output_times = {1.0}};
  Trajectory path;
  for (auto _ : state) path = find_scheme("l1")->solve(scene.problem, Grid{1.0, steps}, options);
  if (path.status != SolveStatus::finished) state.SkipWithError("not finished");
  state.counters["per_unknown_and_step"] = benchmark::Counter(
      unknowns * steps, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

}  // namespace

int main(int count, char** arguments) {
  std::list<Subject> subjects;  // stable addresses: the benchmarks keep references
  for (const auto& maker : built_in_scenes()) {
    auto& subject = subjects.emplace_back(maker);
    for (const auto& scheme : schemes()) {
      for (const int steps : {256, 1024, 4096}) {
        if (unsupported_reason(scheme, subject.scene.problem, Grid{subject.scene.problem.end, steps}))
          continue;
        benchmark::RegisterBenchmark(
            fmt::format("solve/{}/{}/{}", maker.id, scheme.id, steps).c_str(),
            [&subject, &scheme, steps](benchmark::State& state) { solve(state, subject, scheme, steps); })
            ->Unit(benchmark::kMillisecond);
      }
    }
  }
  for (auto& subject : subjects) {
    if (subject.id != "pendulum" && subject.id != "brusselator") continue;
    for (const auto* id : {"adams_pc", "product_trapezoidal"}) {
      for (const auto kind : {HistoryKind::direct, HistoryKind::exponentials}) {
        for (const int steps : {1 << 10, 1 << 12, 1 << 15, 1 << 20}) {
          if (kind == HistoryKind::direct && steps > 1 << 15) continue;  // minutes
          benchmark::RegisterBenchmark(
              fmt::format("history/{}/{}/{}/{}", subject.id, id, name(kind), steps).c_str(),
              [&subject, id, kind, steps](benchmark::State& state) {
                solve(state, subject, *find_scheme(id), steps, kind);
              })
              ->Unit(benchmark::kMillisecond);
        }
      }
    }
  }
  for (const int threads : {1, 2}) {
    benchmark::RegisterBenchmark(fmt::format("many_unknowns/threads/{}", threads).c_str(), many_unknowns,
                                 threads)
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
  }
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
