#include "fdebench/benchmarks/measures/measures.hpp"

namespace fde {
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

}  // namespace

constinit const Measure measure::energy_residual{"energy_residual", "",
                                                 observed<&RunObservations::energy_residual>};
constinit const Measure measure::drift_internal{"drift_internal", "",
                                                largest<&RunObservations::internal_drift>};
constinit const Measure measure::drift_internal_growth{"drift_internal_growth", "",
                                                       growth<&RunObservations::internal_drift>};
constinit const Measure measure::drift_independent{"drift_independent", "",
                                                   largest<&RunObservations::independent_drift>};
constinit const Measure measure::drift_independent_growth{"drift_independent_growth", "",
                                                          growth<&RunObservations::independent_drift>};
constinit const Measure measure::expected_rate_end{"expected_rate_end", "",
                                                   observed<&RunObservations::expected_rate_end>};
constinit const Measure measure::expected_rate_maximum{"expected_rate_maximum", "",
                                                       observed<&RunObservations::expected_rate_maximum>};

}  // namespace fde
