#include "fdebench/benchmarks/measures/measures.hpp"

namespace fde {
namespace {

using Value = std::optional<double>;

template <auto count>
Value cost(const FinishedRun& run) {
  const auto& counted = run.path.cost.*count;
  return counted ? Value(static_cast<double>(*counted)) : std::nullopt;
}

}  // namespace

constinit const Measure measure::rhs_calls{"rhs_calls", "", cost<&Cost::rhs_calls>};
constinit const Measure measure::newton_iterations{"newton_iterations", "", cost<&Cost::newton_iterations>};
constinit const Measure measure::history_bytes{"history_bytes", "B", cost<&Cost::history_bytes>};
constinit const Measure measure::states{"states", "", cost<&Cost::states>};
constinit const Measure measure::rejected_steps{"rejected_steps", "", cost<&Cost::rejected_steps>};
constinit const Measure measure::start_weights{"start_weights", "", cost<&Cost::start_weights>};

}  // namespace fde
