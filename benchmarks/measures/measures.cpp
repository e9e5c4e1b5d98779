// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/measures/column_errors.hpp"
#include "fdebench/benchmarks/measures/timing_conditions.hpp"

namespace fde::bench {
namespace {

using Seconds = std::optional<double>;

Seconds setup(const TimedSolves& timed) {
  return timed.setup_seconds > 0.0 ? Seconds(timed.setup_seconds) : std::nullopt;
}
Seconds start(const TimedSolves& timed) { return timed.start_seconds; }
Seconds minimum(const TimedSolves& timed) { return std::ranges::min(timed.seconds); }
Seconds median(const TimedSolves& timed) { return spread_of(timed.seconds).median; }
Seconds low(const TimedSolves& timed) { return spread_of(timed.seconds).low; }
Seconds high(const TimedSolves& timed) { return spread_of(timed.seconds).high; }

template <auto condition>
std::optional<double> observed(const TimedSolves& timed) {
  return timed.conditions ? std::optional<double>((*timed.conditions).*condition) : std::nullopt;
}
std::optional<double> disturbed(const TimedSolves& timed) {
  return timed.waited.empty() ? std::nullopt : std::optional(is_disturbed(timed) ? 1.0 : 0.0);
}

constexpr std::array all_of_time{
    TimeMeasure{"time_start", start},
    TimeMeasure{"time_setup", setup},
    TimeMeasure{"time_minimum", minimum},
    TimeMeasure{"time_median", median},
    TimeMeasure{"time_low", low},
    TimeMeasure{"time_high", high},
    TimeMeasure{"load", observed<&TimingConditions::load>, ""},
    TimeMeasure{"switches", observed<&TimingConditions::switches>, ""},
    TimeMeasure{"frequency", observed<&TimingConditions::frequency>, "Hz"},
    TimeMeasure{"disturbed", disturbed, ""},
};

}  // namespace

std::span<const Measure* const> measures() {
  static const std::vector<const Measure*> all = [] {
    std::vector<const Measure*> rows;
    for (const Measure& of_kind : error_measures()) rows.push_back(&of_kind);
#define FDE_MEASURE(id) rows.push_back(&measure::id);
#include "fdebench/benchmarks/measures/list.def"
#undef FDE_MEASURE
    return rows;
  }();
  return all;
}

std::span<const TimeMeasure> time_measures() { return all_of_time; }

bool is_disturbed(const TimedSolves& timed) {
  constexpr double most_waited = 0.02, clock = 5e-6, most_spread = 1.1;
  std::vector<std::pair<double, double>> solves;  // seconds, waited
  for (std::size_t i = 0; i < timed.seconds.size(); ++i)
    solves.emplace_back(timed.seconds[i], timed.waited.at(i));
  const auto median = solves.begin() + std::ssize(solves) / 2;
  std::ranges::nth_element(solves, median);
  const auto [seconds, waited] = *median;
  return waited > most_waited * seconds + clock ||
         seconds > most_spread * std::ranges::min(timed.seconds) + clock;
}

double mescd(const Rows& values, const Rows& reference) {
  const auto error = (values.rightCols(1) - reference.rightCols(1)).array().abs();
  const double relative = (error / (1.0 + reference.rightCols(1).array().abs())).maxCoeff();
  return -std::log10(std::max(relative, 1e-17));
}

}  // namespace fde::bench
