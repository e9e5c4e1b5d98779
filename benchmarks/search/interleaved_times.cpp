// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/interleaved_times.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>

namespace fde::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Mean seconds of a solve over `times` successive solves.
double seconds_each(const std::function<void()>& solve, int times) {
  const auto start = Clock::now();
  for (int i = 0; i < times; ++i) solve();
  return seconds_since(start) / times;
}

// The number of solves that takes 1 ms, long enough for the clock.
int times_in_a_round(const TimedSolve& timed) {
  constexpr double least = 1e-3;
  constexpr int most = 1000;
  if (timed.expected_seconds > least) return 1;
  timed.solve();
  const double each = seconds_each(timed.solve, 1);
  return each * most < least ? most : std::max(1, static_cast<int>(std::ceil(least / each)));
}

std::vector<MedianInterval> intervals(const std::vector<std::vector<double>>& measured) {
  std::vector<MedianInterval> all;
  for (const auto& one : measured) all.push_back(spread_of(one));
  return all;
}

// Whether the interval of the quickest is below all others.
bool is_decided(const std::vector<std::vector<double>>& measured) {
  const auto times = intervals(measured);
  const auto first = std::ranges::min_element(times, {}, &MedianInterval::median);
  return std::ranges::all_of(
      times, [&](const MedianInterval& time) { return &time == &*first || time.low > first->high; });
}

}  // namespace

std::vector<MedianInterval> time_interleaved(const std::vector<TimedSolve>& solves, double seconds) {
  constexpr std::size_t most_rounds = 201, rounds_between = 10;
  constexpr double long_round = 0.5;
  std::vector<int> times;
  double round_seconds = 0.0;
  for (const TimedSolve& timed : solves) {
    times.push_back(times_in_a_round(timed));
    round_seconds += timed.expected_seconds;
  }
  const std::size_t fewest_rounds = round_seconds > long_round ? 2 : 3;
  std::vector<std::vector<double>> measured(solves.size());
  const auto start = Clock::now();
  for (std::size_t round = 0;
       round < fewest_rounds || (round < most_rounds && seconds_since(start) < seconds); ++round) {
    for (std::size_t i = 0; i < solves.size(); ++i)
      measured[i].push_back(seconds_each(solves[i].solve, times[i]));
    if (round > 0 && round % rounds_between == 0 && is_decided(measured)) break;
  }
  return intervals(measured);
}

}  // namespace fde::bench
