// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/timing_conditions.hpp"

#include <fmt/format.h>
#include <sched.h>
#include <sys/resource.h>

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

}  // namespace fde::bench
