// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/interleaved_times.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>

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

// The solves that are still timed, with their times so far.
class Race {
 public:
  explicit Race(const std::vector<TimedSolve>& solves) : solves_(solves), measured_(solves.size()) {
    for (std::size_t i = 0; i < solves.size(); ++i) {
      times_.push_back(times_in_a_round(solves[i]));
      left_.push_back(i);
    }
  }

  void make_round() {
    for (const std::size_t i : left_) measured_[i].push_back(seconds_each(solves_[i].solve, times_[i]));
  }

  // Leaves the solves whose intervals are above that of the quickest.
  void leave_slower() {
    MedianInterval quickest{.median = std::numeric_limits<double>::infinity()};
    for (const std::size_t i : left_) {
      const auto time = spread_of(measured_[i]);
      if (time.median < quickest.median) quickest = time;
    }
    std::erase_if(left_, [&](std::size_t i) { return spread_of(measured_[i]).low > quickest.high; });
  }

  // Whether one is left, or all that are left are known so well that more rounds would not part them.
  [[nodiscard]] bool is_decided() const {
    constexpr double known = 0.02;
    return left_.size() == 1 || std::ranges::all_of(left_, [&](std::size_t i) {
             const auto time = spread_of(measured_[i]);
             return time.high - time.low < known * time.median;
           });
  }

  [[nodiscard]] std::vector<MedianInterval> intervals() const {
    std::vector<MedianInterval> all;
    for (const auto& one : measured_) all.push_back(spread_of(one));
    return all;
  }

 private:
  const std::vector<TimedSolve>& solves_;
  std::vector<int> times_{};  // solves in a round
  std::vector<std::size_t> left_{};
  std::vector<std::vector<double>> measured_;
};

}  // namespace

std::vector<MedianInterval> time_interleaved(const std::vector<TimedSolve>& solves, double seconds) {
  constexpr std::size_t most_rounds = 201, fewest_rounds = 6, fewest_long_rounds = 3;
  constexpr double long_round = 0.2;
  Race race(solves);
  const auto start = Clock::now();
  for (std::size_t round = 1; round <= most_rounds; ++round) {
    race.make_round();
    const double taken = seconds_since(start);
    if (round < (taken > long_round * static_cast<double>(round) ? fewest_long_rounds : fewest_rounds))
      continue;
    race.leave_slower();
    if (race.is_decided() || taken >= seconds) break;
  }
  return race.intervals();
}

}  // namespace fde::bench
