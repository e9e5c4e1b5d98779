// SPDX-License-Identifier: MIT
// The time to compute what a multistep rule needs before its first solve, as in a fresh process: how many
// powers are usable, and the start weights for 300 steps.

#include "fdebench/schemes/rules/start_weights/start_weights.hpp"

#include <benchmark/benchmark.h>

#include <deque>
#include <string>
#include <vector>

namespace {

using namespace fde;

// Nothing comes from a cache: each iteration has its own copy of the family.
void start_weights(benchmark::State& state, const WeightFamily* family, const std::vector<double>& orders) {
  constexpr int steps = 300;
  static std::deque<WeightFamily> copies;
  std::size_t powers = 0;
  for (auto _ : state) {
    const auto& own = copies.emplace_back(*family);
    const auto start = starting_powers(own, orders, orders);
    powers = start.powers.size();
    for (const double order : orders)
      benchmark::DoNotOptimize(starting_weights({&own, order}, start.for_steps(steps), steps));
  }
  state.counters["powers"] = static_cast<double>(powers);
}

struct Orders {
  const char* name;
  std::vector<double> values;
};

int register_all() {
  const std::vector<Orders> cases{{"0.5", {0.5}},
                                  {"0.2", {0.2}},
                                  {"0.8", {0.8}},
                                  {"pendulum", {1.5, 0.5}},
                                  {"three_orders", {0.37, 0.81, 1.62}},
                                  {"near_each_other", {0.5, 0.50003}},
                                  {"tiny", {0.0003}}};
  for (const auto* family :
       {&families::bdf2, &families::bdf3, &families::bdf4, &families::bdf5, &families::bdf6,
        &families::newton_gregory_2, &families::newton_gregory_3, &families::fractional_trapezoidal}) {
    for (const auto& [name, orders] : cases) {
      const auto full_name = "start_weights/" + std::string(family->id) + "/" + name;
      benchmark::RegisterBenchmark(full_name.c_str(), start_weights, family, orders)
          ->Unit(benchmark::kMicrosecond);
    }
  }
  return 0;
}
[[maybe_unused]] const int registered = register_all();

}  // namespace

BENCHMARK_MAIN();
