// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/interleaved_times.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace fde::bench {
namespace {

// A solve that waits, and counts its calls.
TimedSolve waiting(std::chrono::microseconds time, int& calls) {
  return {[time, &calls] {
            ++calls;
            const auto end = std::chrono::steady_clock::now() + time;
            while (std::chrono::steady_clock::now() < end) {
            }
          },
          std::chrono::duration<double>(time).count()};
}

// A thousand times as long as the other one: no disturbance makes the intervals meet.
TEST(InterleavedTimes, LeaveTheSlowerAfterSixRounds) {
  using namespace std::chrono_literals;
  constexpr double seconds = 10.0;
  int of_quick = 0, of_slow = 0;
  const auto times = time_interleaved({waiting(20us, of_quick), waiting(20ms, of_slow)}, seconds);
  EXPECT_EQ(of_slow, 6);
  EXPECT_GT(of_quick, 6) << "a short solve is repeated within a round";
  EXPECT_LT(times[0].high, times[1].low);
  EXPECT_GE(times[1].median, 20e-3);
}

TEST(InterleavedTimes, AreOfThreeSolvesWhereTheseAreLong) {
  using namespace std::chrono_literals;
  int calls = 0;
  const auto time = time_interleaved({waiting(210ms, calls)}, 0.0).front();
  EXPECT_EQ(calls, 3);
  EXPECT_EQ(time.confidence, 0.75);
}

}  // namespace
}  // namespace fde::bench
