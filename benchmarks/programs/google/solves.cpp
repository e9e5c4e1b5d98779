// SPDX-License-Identifier: MIT
// solve/<scene>/<scheme>/<N> for every scene and every scheme that accepts it: time, error of the solution
// and Newton iterations. history/<scene>/<scheme>/<engine>/<N> compares the history engines on whole solves.
// large/<variant>/<scheme>/<N> compares L1 with the schemes with start weights on 10^4 unknowns.
// steps/<scene>/<scheme>/<N> has the time of a step in long runs, per_step.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <list>

#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"

namespace {

using namespace fde;
using namespace fde::bench;

// A scene with its reference, which is computed once, by the first benchmark of the scene.
struct Subject {
  explicit Subject(const SceneFactory& factory) : id(factory.id), scene(make_scene(factory)) {}
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

// A whole run, first steps included: time for each unknown and step, and memory of the history an unknown.
void solve_large(benchmark::State& state, const std::string& variant, const Scheme& scheme, int steps,
                 int threads = 1) {
  const Scene scene = make_scene(parse_variant(variant));
  const Grid grid{.end = scene.problem.end, .steps = steps};
  Trajectory path;
  for (auto _ : state)
    path = scheme.solve(scene.problem, grid, {.threads = threads, .output_times = {grid.end}});
  if (path.status != SolveStatus::finished) {
    state.SkipWithError(describe(scene.problem, path).c_str());
    return;
  }
  const auto unknowns = static_cast<double>(scene.problem.size());
  state.counters["history_bytes_per_unknown"] = static_cast<double>(*path.cost.history_bytes) / unknowns;
  state.counters["per_unknown_and_step"] = benchmark::Counter(
      unknowns * steps, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void register_large() {
  for (const std::string& variant :
       std::vector<std::string>{"fractional_diffusion_2d:n=100", "fractional_diffusion_2d:n=100,medium=wave",
                                "fractional_diffusion:components=10000", "fractional_allen_cahn:n=10000",
                                "fractional_allen_cahn:domain=square,n=100"}) {
    for (const auto& scheme : schemes()) {
      const bool has_start_weights = scheme.starting_powers && !scheme.capabilities.discretises_equations;
      if (scheme.id != "l1" && !has_start_weights) continue;
      for (const int steps : {200, 1000}) {
        benchmark::RegisterBenchmark(fmt::format("large/{}/{}/{}", variant, scheme.id, steps).c_str(),
                                     [variant, &scheme, steps](benchmark::State& state) {
                                       solve_large(state, variant, scheme, steps);
                                     })
            ->Unit(benchmark::kMillisecond);
      }
    }
  }
  for (const int threads : {1, 2}) {
    benchmark::RegisterBenchmark(
        fmt::format("large/fractional_diffusion:components=1000000/l1/200/threads:{}", threads).c_str(),
        [threads](benchmark::State& state) {
          solve_large(state, "fractional_diffusion:components=1000000", *find_scheme("l1"), 200, threads);
        })
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
  }
}

void register_steps(std::list<Subject>& subjects) {
  for (auto& subject : subjects) {
    if (subject.id != "pendulum" && subject.id != "relaxation" && subject.id != "brusselator") continue;
    for (const auto* id : {"adams_pc", "decoupled_multi_order", "l1", "l2_1_sigma", "grunwald_letnikov",
                           "product_trapezoidal", "bdf2", "bdf6", "multi_term_trapezoidal"}) {
      for (const int steps : {100'000, 1'000'000}) {
        if (unsupported_reason(*find_scheme(id), subject.scene.problem,
                               Grid{subject.scene.problem.end, steps}))
          continue;
        benchmark::RegisterBenchmark(fmt::format("steps/{}/{}/{}", subject.id, id, steps).c_str(),
                                     [&subject, id, steps](benchmark::State& state) {
                                       solve(state, subject, *find_scheme(id), steps);
                                     })
            ->Unit(benchmark::kMillisecond);
      }
    }
    if (subject.id == "brusselator") continue;
    constexpr int most = 100'000'000;
    benchmark::RegisterBenchmark(
        fmt::format("steps/{}/adams_pc/{}", subject.id, most).c_str(),
        [&subject](benchmark::State& state) { solve(state, subject, *find_scheme("adams_pc"), most); })
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1);
  }
}

}  // namespace

int main(int count, char** arguments) {
  std::list<Subject> subjects;  // stable addresses: the benchmarks keep references
  for (const auto& factory : built_in_scenes()) {
    auto& subject = subjects.emplace_back(factory);
    for (const auto& scheme : schemes()) {
      for (const int steps : {256, 1024, 4096}) {
        if (unsupported_reason(scheme, subject.scene.problem, Grid{subject.scene.problem.end, steps}))
          continue;
        benchmark::RegisterBenchmark(
            fmt::format("solve/{}/{}/{}", factory.id, scheme.id, steps).c_str(),
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
  register_large();
  register_steps(subjects);
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
