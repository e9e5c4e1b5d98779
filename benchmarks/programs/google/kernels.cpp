// SPDX-License-Identifier: MIT
// Time of one weight, and of one value of the Mittag-Leffler function. For histories: histories.cpp.

#include <benchmark/benchmark.h>

#include <cmath>

#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "fdebench/schemes/history/weights/weights.hpp"

namespace {

using namespace fde;

void weights(benchmark::State& state, const WeightFamily* family) {
  std::int64_t lag = 1;
  for (auto _ : state) {
    benchmark::DoNotOptimize(weight({family, 0.5}, lag));
    lag = lag % 100'000 + 1;
  }
}
BENCHMARK_CAPTURE(weights, rectangle, &families::rectangle);
BENCHMARK_CAPTURE(weights, trapezoid, &families::trapezoid);
BENCHMARK_CAPTURE(weights, grunwald_letnikov, &families::grunwald_letnikov);
BENCHMARK_CAPTURE(weights, l1, &families::l1);

// E_{a,1}(-x), x from 0 to 100. The argument of the benchmark is 10 a.
void mittag_leffler_double(benchmark::State& state) {
  const double alpha = 0.1 * static_cast<double>(state.range(0));
  double x = 0.0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(reference::mittag_leffler(alpha, 1.0, -x));
    x = std::fmod(x + 0.37, 100.0);
  }
}
BENCHMARK(mittag_leffler_double)->Arg(2)->Arg(5)->Arg(9)->Arg(13)->Arg(17);

void mittag_leffler_digits(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        reference::mittag_leffler("0.5", "1", "-1", "0", static_cast<int>(state.range(0))));
  }
}
BENCHMARK(mittag_leffler_digits)->Arg(50)->Arg(200)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
