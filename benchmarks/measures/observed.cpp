// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/measures.hpp"

namespace fde::bench {

namespace {

using Value = std::optional<double>;

template <Value RunObservations::*seen>
Value observed(const FinishedRun& run) {
  return run.observed.*seen;
}

using OneDrift = std::optional<Drift> RunObservations::*;
template <OneDrift drift>
Value largest(const FinishedRun& run) {
  const auto& seen = run.observed.*drift;
  return seen ? Value(seen->largest) : std::nullopt;
}
template <OneDrift drift>
Value growth(const FinishedRun& run) {
  const auto& seen = run.observed.*drift;
  return seen ? seen->growth : std::nullopt;
}
template <OneDrift drift>
Course course(const FinishedRun& run) {
  const auto& seen = run.observed.*drift;
  return seen ? seen->course : Course{};
}

template <auto count>
Value cost(const FinishedRun& run) {
  const auto& counted = run.path.cost.*count;
  return counted ? Value(static_cast<double>(*counted)) : std::nullopt;
}

}  // namespace

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
