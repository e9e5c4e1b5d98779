// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/errors.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "fdebench/benchmarks/measures/accuracy.hpp"

namespace fde::bench {
namespace {

using Value = std::optional<double>;

bool has_reference(const FinishedRun& run) { return run.reference.cols() > 0; }
bool has_rounding(const FinishedRun& run) { return run.observed.rounded.cols() > 0; }

template <std::size_t kind>
Value error(const FinishedRun& run) {
  if (!has_reference(run)) return std::nullopt;
  const auto [norm, scale] = error_kinds[kind];
  return error_of(norm, run.values, run.reference, divisors(scale, run.path.times, run.reference));
}

// The constant-solution baseline, if the run is not better.
template <std::size_t kind>
Value baseline(const FinishedRun& run) {
  const bool from_start = run.path.times.size() > 1 && run.path.times.front() == 0.0;
  if (!has_reference(run) || (from_start && is_constant(run.reference, run.reference_bounds)))
    return std::nullopt;
  const auto [norm, scale] = error_kinds[kind];
  const auto& times = run.path.times;
  const double least =
      constant_solution_error(norm, times, run.reference, divisors(scale, times, run.reference));
  return least <= *error<kind>(run) ? Value(least) : std::nullopt;
}

// The variation within one step, where it is more than the maximum error at the steps.
template <Scale scale>
Value unresolved(const FinishedRun& run) {
  constexpr std::size_t kind =
      std::ranges::find(error_kinds, ErrorKind{Norm::maximum, scale}) - error_kinds.begin();
  const Vec& variation = run.observed.unresolved.at(static_cast<std::size_t>(scale));
  if (!has_reference(run) || variation.size() == 0) return std::nullopt;
  const double largest = variation.maxCoeff();
  return largest > *error<kind>(run) ? Value(largest) : std::nullopt;
}

template <Scale scale>
constexpr Measure unresolved_row{.id = unresolved_measure(scale), .value = unresolved<scale>};

template <std::size_t... kind>
constexpr auto rows_of_kinds(std::index_sequence<kind...> /*kinds*/) {
  return std::array{
      Measure{.id = error_measure(error_kinds[kind]), .value = error<kind>, .error = error_kinds[kind]}...,
      Measure{.id = baseline_measure(error_kinds[kind]), .value = baseline<kind>}...,
      unresolved_row<Scale::absolute>,
      unresolved_row<Scale::relative>,
      unresolved_row<Scale::mixed>,
      unresolved_row<Scale::peak>};
}

Value digits(const FinishedRun& run) {
  return has_reference(run) ? Value(mescd(run.values, run.reference)) : std::nullopt;
}

Value relative(const FinishedRun& run) {
  return has_reference(run) ? relative_error(run.values, run.reference, run.reference_bounds.rightCols(1))
                            : std::nullopt;
}

Value rounding_at_end(const FinishedRun& run) {
  if (!has_rounding(run)) return std::nullopt;
  return (run.values - run.observed.rounded).rightCols(1).cwiseAbs().maxCoeff();
}

Value rounding_dominates_from(const FinishedRun& run) {
  if (!has_reference(run) || !has_rounding(run)) return std::nullopt;
  const auto column = rounding_dominates(run.values, run.observed.rounded, run.reference);
  if (!column) return std::nullopt;
  return run.path.time(*column);
}

template <Norm norm>
Value bound(const FinishedRun& run) {
  if (!has_reference(run)) return std::nullopt;
  const auto columns = norm == Norm::end ? 1 : run.reference_bounds.cols();
  return run.reference_bounds.rightCols(columns).maxCoeff();
}

}  // namespace

std::span<const Measure> error_measures() {
  static constexpr auto all = rows_of_kinds(std::make_index_sequence<error_kinds.size()>{});
  return all;
}

constinit const Measure measure::error_relative{
    .id = "error_relative", .value = relative, .error = ErrorKind{Norm::end, Scale::relative}};
constinit const Measure measure::rounding{.id = "rounding", .value = rounding_at_end};
constinit const Measure measure::rounding_from{
    .id = "rounding_from", .unit = "t", .value = rounding_dominates_from};
constinit const Measure measure::mescd{
    .id = "mescd", .unit = "digits", .value = digits, .may_be_negative = true};
constinit const Measure measure::reference_bound{.id = "reference_bound", .value = bound<Norm::end>};
constinit const Measure measure::reference_bound_maximum{.id = "reference_bound_maximum",
                                                         .value = bound<Norm::maximum>};

}  // namespace fde::bench
