// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/measures.hpp"

namespace fde::bench {
namespace {

using Value = std::optional<double>;

template <auto count>
Value cost(const FinishedRun& run) {
  const auto& counted = run.path.cost.*count;
  return counted ? Value(static_cast<double>(*counted)) : std::nullopt;
}

}  // namespace

constinit const Measure measure::rhs_calls{.id = "rhs_calls", .value = cost<&Cost::rhs_calls>};
constinit const Measure measure::newton_iterations{.id = "newton_iterations",
                                                   .value = cost<&Cost::newton_iterations>};
constinit const Measure measure::history_bytes{
    .id = "history_bytes", .unit = "B", .value = cost<&Cost::history_bytes>};
constinit const Measure measure::states{.id = "states", .value = cost<&Cost::components>};
constinit const Measure measure::rejected_steps{.id = "rejected_steps", .value = cost<&Cost::rejected_steps>};
constinit const Measure measure::start_weights{.id = "start_weights", .value = cost<&Cost::starting_weights>};

}  // namespace fde::bench
