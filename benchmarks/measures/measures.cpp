#include "measures/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "measures/accuracy.hpp"

namespace fde {
namespace {

bool has_reference(const Observation& run) { return run.reference.cols() > 0; }

template <auto count>
bool counted(const Observation& run) {
  return (run.path.cost.*count).has_value();
}
template <auto count>
double cost(const Observation& run) {
  return static_cast<double>(*(run.path.cost.*count));
}
bool newton_counted(const Observation& run) {
  return run.scheme.needs.implicit && counted<&Cost::newton_iterations>(run);
}

bool has_rate(const Observation& run) { return static_cast<bool>(run.scheme.expected_rate); }
template <Norm norm>
double expected_rate(const Observation& run) {
  return run.scheme.expected_rate(run.scene.problem, run.scene.smoothness, run.grading, norm);
}

using OneDrift = std::optional<Drift> Observation::*;
constexpr OneDrift internal = &Observation::internal_drift, independent = &Observation::independent_drift;

template <OneDrift drift>
bool has_drift(const Observation& run) {
  return (run.*drift).has_value();
}
template <OneDrift drift>
double largest(const Observation& run) {
  return (run.*drift)->largest;
}
template <OneDrift drift>
bool has_growth(const Observation& run) {
  return has_drift<drift>(run) && (run.*drift)->growth.has_value();
}
template <OneDrift drift>
double growth(const Observation& run) {
  return *(run.*drift)->growth;
}

double median(const std::vector<double>& seconds) {
  auto values = seconds;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return values.size() % 2 == 1 ? *middle : 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

bool has_relative_error(const Observation& run) {
  return has_reference(run) && relative_error(run.values, run.reference, run.reference_bound).has_value();
}
bool has_rounding(const Observation& run) { return run.rounded.cols() > 0; }
bool has_rounding_from(const Observation& run) {
  return has_reference(run) && has_rounding(run) &&
         rounding_dominates(run.values, run.rounded, run.reference).has_value();
}
double rounding_from(const Observation& run) {
  return run.path.time(*rounding_dominates(run.values, run.rounded, run.reference));
}

constexpr std::array all{
    Measure{"error_end", "", has_reference, error_end},
    Measure{"error_maximum", "", has_reference, error_maximum},
    Measure{"error_relative", "", has_relative_error,
            [](const Observation& run) {
              return *relative_error(run.values, run.reference, run.reference_bound);
            }},
    Measure{"rounding", "", has_rounding,
            [](const Observation& run) {
              return (run.values.rightCols(1) - run.rounded.rightCols(1)).cwiseAbs().maxCoeff();
            }},
    Measure{"rounding_from", "t", has_rounding_from, rounding_from},
    Measure{"mescd", "digits", has_reference, mescd},
    Measure{"reference_bound", "", has_reference,
            [](const Observation& run) { return run.reference_bound.maxCoeff(); }},
    Measure{"energy_residual", "", [](const Observation& run) { return run.energy_residual.has_value(); },
            [](const Observation& run) { return *run.energy_residual; }},
    Measure{"drift_internal", "", has_drift<internal>, largest<internal>},
    Measure{"drift_internal_growth", "", has_growth<internal>, growth<internal>},
    Measure{"drift_independent", "", has_drift<independent>, largest<independent>},
    Measure{"drift_independent_growth", "", has_growth<independent>, growth<independent>},
    Measure{"rhs_calls", "", counted<&Cost::rhs_calls>, cost<&Cost::rhs_calls>},
    Measure{"newton_iterations", "", newton_counted, cost<&Cost::newton_iterations>},
    Measure{"history_bytes", "B", counted<&Cost::history_bytes>, cost<&Cost::history_bytes>},
    Measure{"states", "", counted<&Cost::states>, cost<&Cost::states>},
    Measure{"expected_rate_end", "", has_rate, expected_rate<Norm::end>},
    Measure{"expected_rate_maximum", "", has_rate, expected_rate<Norm::maximum>},
};

constexpr std::array all_of_time{
    TimeMeasure{"time_minimum", [](const std::vector<double>& seconds) { return std::ranges::min(seconds); }},
    TimeMeasure{"time_median", median},
};

}  // namespace

std::span<const Measure> measures() { return all; }
std::span<const TimeMeasure> time_measures() { return all_of_time; }

double error_end(const Observation& run) {
  return (run.values.rightCols(1) - run.reference.rightCols(1)).cwiseAbs().maxCoeff();
}

double error_maximum(const Observation& run) { return (run.values - run.reference).cwiseAbs().maxCoeff(); }

double mescd(const Observation& run) {
  const auto error = (run.values.rightCols(1) - run.reference.rightCols(1)).array().abs();
  const double relative = (error / (1.0 + run.reference.rightCols(1).array().abs())).maxCoeff();
  return -std::log10(std::max(relative, 1e-17));
}

}  // namespace fde
