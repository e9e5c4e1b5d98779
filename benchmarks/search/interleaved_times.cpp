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
int times_in_a_round(const std::function<void()>& solve) {
  constexpr double least = 1e-3;
  constexpr int most = 1000;
  solve();
  const double each = seconds_each(solve, 1);
  return each * most < least ? most : std::max(1, static_cast<int>(std::ceil(least / each)));
}

}  // namespace

std::vector<MedianInterval> time_interleaved(const std::vector<std::function<void()>>& solves,
                                             double seconds) {
  constexpr std::size_t fewest_rounds = 3, most_rounds = 201;
  std::vector<int> times;
  for (const auto& solve : solves) times.push_back(times_in_a_round(solve));
  std::vector<std::vector<double>> measured(solves.size());
  const auto start = Clock::now();
  for (std::size_t round = 0;
       round < fewest_rounds || (round < most_rounds && seconds_since(start) < seconds); ++round) {
    for (std::size_t i = 0; i < solves.size(); ++i) measured[i].push_back(seconds_each(solves[i], times[i]));
  }
  std::vector<MedianInterval> spreads;
  for (auto& one : measured) spreads.push_back(spread_of(std::move(one)));
  return spreads;
}

}  // namespace fde::bench
