// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/timing_conditions.hpp"

#include <fmt/format.h>
#include <sched.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>

namespace fde::bench {

namespace {

std::optional<double> first_number(const std::string& file) {
  std::ifstream stream(file);
  double number = 0.0;
  return stream >> number ? std::optional(number) : std::nullopt;
}

double involuntary_switches() {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return static_cast<double>(usage.ru_nivcsw);
}

// The system gives kHz.
std::optional<double> frequency() {
  constexpr double kilo = 1e3;
  const auto found =
      first_number(fmt::format("/sys/devices/system/cpu/cpu{}/cpufreq/scaling_cur_freq", sched_getcpu()));
  return found ? std::optional(kilo * *found) : std::nullopt;
}

}  // namespace

TimingWatch::TimingWatch() : load_(first_number("/proc/loadavg")), switches_(involuntary_switches()) {}

TimingConditions TimingWatch::conditions() const {
  return {.load = load_, .switches = involuntary_switches() - switches_, .frequency = frequency()};
}

MedianInterval spread_of(std::vector<double> seconds) {
  constexpr double half_width = 0.98;  // 1.96 standard deviations of a binomial number, each sqrt(n) / 2
  constexpr std::size_t fewest = 6;
  std::ranges::sort(seconds);
  const auto last = static_cast<double>(seconds.size() - 1);
  const auto at = [&](double rank) { return seconds[static_cast<std::size_t>(std::clamp(rank, 0.0, last))]; };
  const double median = 0.5 * (at(std::floor(last / 2)) + at(std::ceil(last / 2)));
  if (seconds.size() < fewest) return {median, seconds.front(), seconds.back(), 1.0 - std::exp2(-last)};
  const double ranks = half_width * std::sqrt(last + 1.0);
  return {median, at(std::floor(last / 2 - ranks)), at(std::ceil(last / 2 + ranks))};
}

}  // namespace fde::bench
