// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fdebench/benchmarks/measures/errors.hpp"
#include "fdebench/benchmarks/measures/time_spread.hpp"

namespace fde::bench {
namespace {

using Seconds = std::optional<double>;

Seconds setup(const TimedSolves& timed) {
  return timed.setup_seconds > 0.0 ? Seconds(timed.setup_seconds) : std::nullopt;
}
Seconds minimum(const TimedSolves& timed) { return std::ranges::min(timed.seconds); }
Seconds median(const TimedSolves& timed) { return spread_of(timed.seconds).median; }
Seconds low(const TimedSolves& timed) { return spread_of(timed.seconds).low; }
Seconds high(const TimedSolves& timed) { return spread_of(timed.seconds).high; }

constexpr std::array all_of_time{
    TimeMeasure{"time_setup", setup},   TimeMeasure{"time_minimum", minimum},
    TimeMeasure{"time_median", median}, TimeMeasure{"time_low", low},
    TimeMeasure{"time_high", high},
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

double mescd(const Rows& values, const Rows& reference) {
  const auto error = (values.rightCols(1) - reference.rightCols(1)).array().abs();
  const double relative = (error / (1.0 + reference.rightCols(1).array().abs())).maxCoeff();
  return -std::log10(std::max(relative, 1e-17));
}

}  // namespace fde::bench
