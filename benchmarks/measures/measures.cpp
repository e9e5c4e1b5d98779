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

using Value = std::optional<double>;

template <Value RunObservations::*quantity>
Value observed(const FinishedRun& run) {
  return run.observed.*quantity;
}

using OneDrift = std::optional<Drift> RunObservations::*;
template <OneDrift drift>
Value largest(const FinishedRun& run) {
  const auto& found = run.observed.*drift;
  return found ? Value(found->largest) : std::nullopt;
}
template <OneDrift drift>
Value growth(const FinishedRun& run) {
  const auto& found = run.observed.*drift;
  return found ? found->growth : std::nullopt;
}
template <OneDrift drift>
Course course(const FinishedRun& run) {
  const auto& found = run.observed.*drift;
  return found ? found->course : Course{};
}

template <auto count>
Value cost(const FinishedRun& run) {
  const auto& counted = run.path.cost.*count;
  return counted ? Value(static_cast<double>(*counted)) : std::nullopt;
}

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

constinit const Measure measure::energy_residual{.id = "energy_residual",
                                                 .value = observed<&RunObservations::energy_residual>};
constinit const Measure measure::drift_internal{.id = "drift_internal",
                                                .value = largest<&RunObservations::internal_drift>,
                                                .course = course<&RunObservations::internal_drift>};
constinit const Measure measure::drift_internal_growth{.id = "drift_internal_growth",
                                                       .value = growth<&RunObservations::internal_drift>,
                                                       .may_be_negative = true};
constinit const Measure measure::drift_independent{.id = "drift_independent",
                                                   .value = largest<&RunObservations::independent_drift>,
                                                   .course = course<&RunObservations::independent_drift>};
constinit const Measure measure::drift_independent_growth{
    .id = "drift_independent_growth",
    .value = growth<&RunObservations::independent_drift>,
    .may_be_negative = true};
constinit const Measure measure::expected_rate_end{.id = "expected_rate_end",
                                                   .value = observed<&RunObservations::expected_rate_end>,
                                                   .may_be_negative = true};
constinit const Measure measure::expected_rate_maximum{
    .id = "expected_rate_maximum",
    .value = observed<&RunObservations::expected_rate_maximum>,
    .may_be_negative = true};

constinit const Measure measure::rhs_calls{.id = "rhs_calls", .value = cost<&Cost::rhs_calls>};
constinit const Measure measure::newton_iterations{.id = "newton_iterations",
                                                   .value = cost<&Cost::newton_iterations>};
constinit const Measure measure::history_bytes{
    .id = "history_bytes", .unit = "B", .value = cost<&Cost::history_bytes>};
constinit const Measure measure::states{.id = "states", .value = cost<&Cost::components>};
constinit const Measure measure::rejected_steps{.id = "rejected_steps", .value = cost<&Cost::rejected_steps>};
constinit const Measure measure::start_weights{.id = "start_weights", .value = cost<&Cost::starting_weights>};

}  // namespace fde::bench
