// SPDX-License-Identifier: MIT
// The time of a step of the history (push and convolve) for a predictor-corrector with four components of
// equal order, against the number of steps, the number of exponentials and the vector target; and of the same
// multiply-adds in a plain loop. The result is per_step: a whole run, tables included, over the number of
// steps.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "fdebench/benchmarks/programs/google/bare_loop.hpp"
#include "fdebench/schemes/history/block_kernels.hpp"
#include "fdebench/schemes/history/exponential_memory.hpp"
#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/history/parallel_for_rows.hpp"

namespace {

using namespace fde;
using namespace fde::bench;

constexpr Eigen::Index components = 4;
constexpr double order = 0.5, full = 1e-15;

WeightTables predictor_corrector() {
  return {std::vector<WeightTable>(components, {&families::rectangle, order}),
          std::vector<WeightTable>(components, {&families::trapezoid, order})};
}

// Time of an iteration divided by `count`.
benchmark::Counter per_iteration(Eigen::Index count) {
  return {static_cast<double>(count),
          benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert};
}

// Whole runs of a history.
void run_history(benchmark::State& state, HistoryKind kind, const WeightTables& tables, const Grid& grid,
                 double tolerance) {
  const auto count = std::ssize(tables.front());
  Vec sample = Vec::LinSpaced(count, 0.5, 1.5), sum(count);
  for (auto _ : state) {
    const auto history = make_history(kind, tables, step_plan(grid), tolerance);
    double t = 0.0;
    for (int n = 1; n <= grid.steps; ++n) {
      history->push(t, sample);
      t = grid.time(n);
      for (std::size_t i = 0; i < tables.size(); ++i) history->convolve(t, i, sum);
      sample[0] = 1.0 + 1e-9 * sum[0];
    }
    benchmark::DoNotOptimize(sum.data());
  }
}

void steps(benchmark::State& state, HistoryKind kind, const Grid& grid, double tolerance) {
  run_history(state, kind, predictor_corrector(), grid, tolerance);
  state.counters["per_step"] = per_iteration(grid.steps);
}

// The history of several components, for each family of one sum.
void choice(benchmark::State& state, HistoryKind kind, const WeightFamily& family, Eigen::Index count,
            const Grid& grid) {
  const WeightTables tables{std::vector<WeightTable>(static_cast<std::size_t>(count), {&family, order})};
  run_history(state, kind, tables, grid, full);
  state.SetLabel(std::string(name(choose_history(kind, tables, step_plan(grid), full).kind)));
}

// choice/<family>/<grid>/<components>/<steps>/<kind>: what `auto` takes, beside both kinds.
void add_choices(const auto& add) {
  for (const auto* family :
       {&families::l1, &families::trapezoid, &families::grunwald_letnikov, &families::bdf2}) {
    for (const double grading : {1.0, 2.0}) {
      if (grading > 1.0 && family->endpoint_values == nullptr) continue;
      for (const Eigen::Index count : {1, 16, 64, 2000, 100'000}) {
        for (const int steps : {16, 24, 31, 48, 64, 96, 192, 512, 1024}) {
          if (count > 2000 && steps > 96) continue;
          for (const auto kind : {HistoryKind::automatic, HistoryKind::direct, HistoryKind::exponentials}) {
            add(fmt::format("choice/{}/{}/{}/{}/{}", family->id, grading > 1.0 ? "graded" : "uniform", count,
                            steps, name(kind)),
                kind, *family, count, Grid{1.0, steps, grading});
          }
        }
      }
    }
  }
}

Eigen::Index nodes(int count, double tolerance) {
  return exponential_sum(order, ExponentialMemory::shortest_lag, count + 2.0, tolerance).nodes.size();
}

// The multiply-adds of a history step in a loop that the compiler vectorises: a lower bound of its time. A
// matrix product of (block x inner) by (inner x components), with `inner` chosen to match their number.
void bare_loop(benchmark::State& state, int count) {
  constexpr Eigen::Index block = ExponentialMemory::block, tables = 2;
  const MemoryTables made({{&families::rectangle, order}, {&families::trapezoid, order}},
                          exponential_sum(order, ExponentialMemory::shortest_lag, count + 2.0, full));
  const Eigen::Index near = ExponentialMemory::recent + block / 2, together = made.far.cols();
  const Eigen::Index joining = 2 * made.points() * made.slow / block;
  const Eigen::Index inner = together + joining + tables * (together + near);
  const Matrix a = Matrix::Random(block, inner), b = Matrix::Random(inner, components);
  Matrix c = Matrix::Zero(block, components);
  for (auto _ : state) {
    bare_multiply_add(inner, components, a.data(), b.data(), c.data());
    benchmark::DoNotOptimize(c.data());
  }
  state.counters["multiply_adds_per_step"] = static_cast<double>(inner * components);
  state.counters["per_step"] = per_iteration(block);
}

// Steps of many components that share one table. NarrowMemory stores each component as a column, WideMemory
// components side by side.
template <class Past>
void many_components(benchmark::State& state, Eigen::Index count, int threads) {
  const RowThreads several(threads);
  constexpr int steps_of_run = 10 * MemoryTables::block;
  const MemoryTables tables({{&families::l1, order}},
                            exponential_sum(1.0 - order, ExponentialMemory::shortest_lag, 1002.0, full));
  Past memory(tables, count);
  const FirstSampleWeights start({{&families::l1, order}}, tables);
  const Vec sample = Vec::LinSpaced(count, 0.5, 1.5);
  Vec sums(count);
  for (auto _ : state) {
    for (int n = 0; n < steps_of_run; ++n) {
      memory.push(tables, n % MemoryTables::block, sample, start);
      memory.convolve(0, (n + 1) % MemoryTables::block, sums.data());
    }
    benchmark::DoNotOptimize(sums.data());
  }
  state.counters["per_step_and_component"] = per_iteration(steps_of_run * count);
}

}  // namespace

int main(int argument_count, char** arguments) {
  const auto add = [](const std::string& name, auto... rest) {
    benchmark::RegisterBenchmark(name.c_str(), rest...)->Unit(benchmark::kMillisecond);
  };
  for (const int count : {48, 64, 96, 128, 192, 256, 512, 1024, 4096, 16384}) {
    add(fmt::format("steps/direct/{}", count), steps, HistoryKind::direct, Grid{1.0, count}, full);
  }
  for (const int count :
       {48, 64, 96, 128, 192, 256, 512, 1024, 4096, 16384, 100'000, 1'000'000, 10'000'000}) {
    add(fmt::format("steps/exponentials/{}", count), steps, HistoryKind::exponentials, Grid{1.0, count},
        full);
  }
  benchmark::RegisterBenchmark("steps/exponentials/100000000", steps, HistoryKind::exponentials,
                               Grid{1.0, 100'000'000}, full)
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1);
  constexpr int usual = 100'000;
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12, full}) {
    add(fmt::format("exponentials/{}", nodes(usual, tolerance)), steps, HistoryKind::exponentials,
        Grid{1.0, usual}, tolerance);
  }
  add(fmt::format("bare_loop/{}", usual), bare_loop, usual);
  for (const int count : {4, 8, 16, 32, 64, 128, 256, 1024, 16384}) {
    const Grid graded{1.0, count, 2.0};
    if (count <= 1024) add(fmt::format("graded/direct/{}", count), steps, HistoryKind::direct, graded, full);
    add(fmt::format("graded/exponentials/{}", count), steps, HistoryKind::exponentials, graded, full);
  }
  const auto targets = vector_targets();
  for (const auto target : targets) {
    add(fmt::format("target/{}", target), [=](benchmark::State& state) {
      select_vector_target(target);
      steps(state, HistoryKind::exponentials, {1.0, usual}, full);
      select_vector_target(targets.front());
    });
  }
  for (const Eigen::Index count : {4, 16, 32, 64, 128, 1'000, 10'000, 100'000, 1'000'000}) {
    add(fmt::format("components/narrow/{}", count), many_components<NarrowMemory>, count, 1);
    for (const int threads : {1, 2}) {
      if (threads > 1 && count < 100'000) continue;
      add(fmt::format("components/wide/{}/threads/{}", count, threads), many_components<WideMemory>, count,
          threads);
    }
  }
  add_choices([](const std::string& name, HistoryKind kind, const WeightFamily& family, Eigen::Index count,
                 const Grid& grid) {
    benchmark::RegisterBenchmark(
        name.c_str(), [=, &family](benchmark::State& state) { choice(state, kind, family, count, grid); });
  });
  benchmark::Initialize(&argument_count, arguments);
  if (benchmark::ReportUnrecognizedArguments(argument_count, arguments)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
