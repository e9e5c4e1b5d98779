// The kernels under everything: one weight, one step of the history, one value of the Mittag-Leffler
// function.

#include <benchmark/benchmark.h>

#include <cmath>

#include "history.hpp"
#include "mittag_leffler.hpp"
#include "weights.hpp"

namespace {

using namespace fde;

void weights(benchmark::State& state, WeightFamily family) {
  std::int64_t lag = 1;
  for (auto _ : state) {
    benchmark::DoNotOptimize(weight({family, 0.5}, lag));
    lag = lag % 100'000 + 1;
  }
}
BENCHMARK_CAPTURE(weights, rectangle, WeightFamily::rectangle);
BENCHMARK_CAPTURE(weights, trapezoid, WeightFamily::trapezoid);
BENCHMARK_CAPTURE(weights, grunwald_letnikov, WeightFamily::grunwald_letnikov);
BENCHMARK_CAPTURE(weights, l1, WeightFamily::l1);

// The sum after N samples of a four-component chain with equal orders.
void history_sum(benchmark::State& state, HistoryKind kind) {
  const auto steps = static_cast<int>(state.range(0));
  const std::vector<WeightTable> tables(4, {WeightFamily::trapezoid, 0.5});
  const auto history = make_history(kind, {tables}, {1.0, steps}, 1e-15);
  Vec sample = Vec::LinSpaced(4, 0.5, 1.5), sum(4);
  for (int n = 0; n < steps; ++n) history->push(sample);
  for (auto _ : state) {
    history->convolve(0, sum);
    benchmark::DoNotOptimize(sum.data());
  }
  state.counters["multiply_adds_per_second"] =
      benchmark::Counter(4.0 * steps, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK_CAPTURE(history_sum, direct, HistoryKind::direct)->RangeMultiplier(4)->Range(1 << 8, 1 << 16);

// The same number of multiply-adds as one plain Eigen dot product: what the history could reach at best.
void bare_dot_product(benchmark::State& state) {
  const Vec a = Vec::Random(4 * state.range(0)), b = Vec::Random(4 * state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(a.dot(b));
  state.counters["multiply_adds_per_second"] =
      benchmark::Counter(static_cast<double>(a.size()), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(bare_dot_product)->RangeMultiplier(4)->Range(1 << 8, 1 << 16);

// E_{a,1}(-x), x from 0 to 100. The argument is a in tenths.
void mittag_leffler_double(benchmark::State& state) {
  const double alpha = 0.1 * static_cast<double>(state.range(0));
  double x = 0.0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(mittag_leffler(alpha, 1.0, -x));
    x = std::fmod(x + 0.37, 100.0);
  }
}
BENCHMARK(mittag_leffler_double)->Arg(2)->Arg(5)->Arg(9)->Arg(13)->Arg(17);

void mittag_leffler_digits(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(mittag_leffler("0.5", "1", "-1", "0", static_cast<int>(state.range(0))));
  }
}
BENCHMARK(mittag_leffler_digits)->Arg(50)->Arg(200)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
