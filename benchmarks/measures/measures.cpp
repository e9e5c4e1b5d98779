#include "measures/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "measures/accuracy.hpp"

namespace fde {
namespace {

using Value = std::optional<double>;

bool has_reference(const FinishedRun& run) { return run.reference.cols() > 0; }
bool has_rounding(const FinishedRun& run) { return run.observed.rounded.cols() > 0; }

template <double (*error)(const Rows& values, const Rows& reference)>
Value against_reference(const FinishedRun& run) {
  return has_reference(run) ? Value(error(run.values, run.reference)) : std::nullopt;
}

Value relative(const FinishedRun& run) {
  return has_reference(run) ? relative_error(run.values, run.reference, run.reference_bound) : std::nullopt;
}

Value rounding(const FinishedRun& run) {
  if (!has_rounding(run)) return std::nullopt;
  return error_end(run.values, run.observed.rounded);
}

Value rounding_from(const FinishedRun& run) {
  if (!has_reference(run) || !has_rounding(run)) return std::nullopt;
  const auto column = rounding_dominates(run.values, run.observed.rounded, run.reference);
  if (!column) return std::nullopt;
  return run.path.time(*column);
}

Value bound_of_reference(const FinishedRun& run) {
  return has_reference(run) ? Value(run.reference_bound.maxCoeff()) : std::nullopt;
}

template <Value Observed::*seen>
Value observed(const FinishedRun& run) {
  return run.observed.*seen;
}

using OneDrift = std::optional<Drift> Observed::*;
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

template <auto count>
Value cost(const FinishedRun& run) {
  const auto& counted = run.path.cost.*count;
  return counted ? Value(static_cast<double>(*counted)) : std::nullopt;
}

double minimum(const std::vector<double>& seconds) { return std::ranges::min(seconds); }

double median(const std::vector<double>& seconds) {
  auto values = seconds;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return values.size() % 2 == 1 ? *middle : 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

constexpr std::array all{
    Measure{"error_end", "", against_reference<error_end>},
    Measure{"error_maximum", "", against_reference<error_maximum>},
    Measure{"error_relative", "", relative},
    Measure{"rounding", "", rounding},
    Measure{"rounding_from", "t", rounding_from},
    Measure{"mescd", "digits", against_reference<mescd>},
    Measure{"reference_bound", "", bound_of_reference},
    Measure{"energy_residual", "", observed<&Observed::energy_residual>},
    Measure{"drift_internal", "", largest<&Observed::internal_drift>},
    Measure{"drift_internal_growth", "", growth<&Observed::internal_drift>},
    Measure{"drift_independent", "", largest<&Observed::independent_drift>},
    Measure{"drift_independent_growth", "", growth<&Observed::independent_drift>},
    Measure{"rhs_calls", "", cost<&Cost::rhs_calls>},
    Measure{"newton_iterations", "", cost<&Cost::newton_iterations>},
    Measure{"history_bytes", "B", cost<&Cost::history_bytes>},
    Measure{"states", "", cost<&Cost::states>},
    Measure{"expected_rate_end", "", observed<&Observed::expected_rate_end>},
    Measure{"expected_rate_maximum", "", observed<&Observed::expected_rate_maximum>},
};

constexpr std::array all_of_time{
    TimeMeasure{"time_minimum", minimum},
    TimeMeasure{"time_median", median},
};

}  // namespace

std::span<const Measure> measures() { return all; }
std::span<const TimeMeasure> time_measures() { return all_of_time; }

double error_end(const Rows& values, const Rows& reference) {
  return (values.rightCols(1) - reference.rightCols(1)).cwiseAbs().maxCoeff();
}

double error_maximum(const Rows& values, const Rows& reference) {
  return (values - reference).cwiseAbs().maxCoeff();
}

double mescd(const Rows& values, const Rows& reference) {
  const auto error = (values.rightCols(1) - reference.rightCols(1)).array().abs();
  const double relative = (error / (1.0 + reference.rightCols(1).array().abs())).maxCoeff();
  return -std::log10(std::max(relative, 1e-17));
}

}  // namespace fde
