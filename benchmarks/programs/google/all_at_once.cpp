// SPDX-License-Identifier: MIT
// all_at_once/<scheme>/<N>: a nonlinear two-sided problem of six rows, three with left and three with right
// derivatives. Prints time, error of the solution, Newton iterations and memory.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "fdebench/benchmarks/scenes/two_sided/manufactured_problem.hpp"

namespace {

using namespace fde;
using namespace fde::bench;

void solve(benchmark::State& state, const Scheme& scheme, int steps) {
  const ManufacturedProblem made = smooth_two_sided();
  const Grid grid{.end = made.problem.end, .steps = steps};
  Trajectory path;
  for (auto _ : state) path = scheme.solve(made.problem, grid, {});
  if (path.status != SolveStatus::finished) {
    state.SkipWithError("not converged");
    return;
  }
  double error = 0.0;
  for (int n = 0; n <= steps; ++n)
    error = std::max(error, (path.y.col(n) - made.exact(grid.time(n))).cwiseAbs().maxCoeff());
  state.counters["error"] = error;
  state.counters["newton"] = static_cast<double>(*path.cost.newton_iterations);
  state.counters["bytes"] = benchmark::Counter(static_cast<double>(*path.cost.history_bytes));
}

}  // namespace

int main(int count, char** arguments) {
  for (const auto& scheme : schemes()) {
    if (!scheme.capabilities.is_two_sided) continue;
    for (const int steps : {1 << 10, 1 << 12, 1 << 14, 1 << 16}) {
      benchmark::RegisterBenchmark(fmt::format("all_at_once/{}/{}", scheme.id, steps).c_str(),
                                   [&scheme, steps](benchmark::State& state) { solve(state, scheme, steps); })
          ->Unit(benchmark::kMillisecond);
    }
  }
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
