// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/observers/comparison_steps.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace fde::bench {
namespace {

// The relative distance from a jump below which times are not resolved: a rounding error d of the time
// changes y ~ s^order by s^(order-1) d, which is rounding error from here on.
double least_after_jump(double order) {
  constexpr double digits = 3.0, always = 1e-12;
  return order < 1.0 ? std::max(always, std::pow(10.0, -digits / (1.0 - order))) : always;
}

// Four times a decade between start and end, down to `least` from the start.
void add_times_towards(double start, double end, double least, std::vector<double>& times) {
  constexpr double ratio = 0.5623413251903491;  // 10^(-1/4)
  for (double since = ratio * (end - start); since >= least; since *= ratio) times.push_back(start + since);
}

}  // namespace

std::vector<int> comparison_steps(int steps, int most) {
  constexpr int first = 16;
  std::vector<int> compared(static_cast<std::size_t>(std::min(steps, most)) + 1);
  std::iota(compared.begin(), compared.end(), 0);
  if (steps <= most) return compared;
  for (auto& n : compared) n = static_cast<int>(std::int64_t{n} * steps / most);
  for (int n = 0; n <= first; ++n) compared.push_back(n);
  return increasing(std::move(compared));
}

int comparison_steps_for(std::size_t columns) {
  constexpr std::size_t most_values = 1U << 18U, least = 1024, most = max_comparison_steps;
  return static_cast<int>(std::clamp(std::bit_floor(most_values / columns), least, most));
}

std::vector<double> comparison_times(const Grid& grid, int most) {
  std::vector<double> times;
  for (const int n : comparison_steps(grid.steps, most)) times.push_back(grid.time(n));
  return times;
}

std::vector<double> comparison_times(const Problem& problem, int evenly) {
  constexpr double rounding = 1e-17;
  constexpr double shortest = 1e-58;  // references need not have settled before the first step of any grid
  auto times = comparison_times(Grid{.end = problem.end, .steps = evenly});
  const double order = smallest_order(problem), least = std::max(shortest, std::pow(rounding, 1.0 / order));
  add_times_towards(0.0, problem.end, least * problem.end, times);
  for (const double jump : problem.jump_times) {
    if (jump < problem.end) add_times_towards(jump, problem.end, least_after_jump(order) * jump, times);
  }
  for (const auto& limit : problem.step_limits) {
    constexpr int between = 8;
    for (int k = 0; k <= between; ++k)
      times.push_back(std::min(limit.from + (limit.to - limit.from) * k / between, problem.end));
  }
  return increasing(std::move(times));
}

}  // namespace fde::bench
