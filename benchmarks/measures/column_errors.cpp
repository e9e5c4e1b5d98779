// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/column_errors.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <utility>

#include "fdebench/benchmarks/measures/accuracy.hpp"
#include "fdebench/benchmarks/measures/measures.hpp"
#include "fdebench/benchmarks/text/rounded_number.hpp"

namespace fde::bench {

namespace {

constexpr int digits_of_errors = 6;

std::vector<double> rounded_errors(const Vec& errors) {
  std::vector<double> values;
  for (const double error : errors) values.push_back(rounded(error, digits_of_errors));
  return values;
}

// Whether a baseline may be as small as the error over some of the columns.
bool can_matter(const std::vector<double>& baselines, const std::vector<double>& errors) {
  const double most = std::ranges::max(errors);
  return std::ranges::any_of(baselines, [&](double baseline) { return baseline > 0.0 && baseline <= most; });
}

double largest_of(const std::vector<double>& values, const std::vector<std::size_t>& places) {
  double most = 0.0;
  for (const auto place : places) most = std::max(most, values.at(place));
  return most;
}

using Value = std::optional<double>;

bool has_reference(const FinishedRun& run) { return run.reference.cols() > 0; }
bool has_rounding(const FinishedRun& run) { return run.observed.rounded.cols() > 0; }

// y = y(0) is no worse than a solution that is constant.
bool is_constant_from_start(const FinishedRun& run, const Rows& reference, const Rows& bounds) {
  return run.path.times.size() > 1 && run.path.times.front() == 0.0 && is_constant(reference, bounds);
}

template <std::size_t kind>
Value error(const FinishedRun& run) {
  if (!has_reference(run)) return std::nullopt;
  return run.errors.run.col(kind).maxCoeff();
}

// The constant-solution baseline, if the run is not better.
template <std::size_t kind>
Value baseline(const FinishedRun& run) {
  if (!has_reference(run)) return std::nullopt;
  const double least = std::min(run.errors.zero.col(kind).maxCoeff(), run.errors.start.col(kind).maxCoeff());
  const bool is_better = !(least <= *error<kind>(run));
  if (is_better || is_constant_from_start(run, run.reference, run.reference_bounds)) return std::nullopt;
  return least;
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

ColumnErrors column_errors(const FinishedRun& run, std::vector<std::string> names, bool is_part) {
  ColumnErrors columns{.names = std::move(names), .is_part = is_part};
  if (columns.names.size() > most_single_columns || run.reference.cols() == 0) return columns;
  Matrix constant = run.errors.zero.cwiseMin(run.errors.start);
  for (Eigen::Index i = 0; i < constant.rows(); ++i) {
    if (is_constant_from_start(run, run.reference.row(i), run.reference_bounds.row(i)))
      constant.row(i).setZero();
  }
  for (std::size_t k = 0; k < error_kinds.size(); ++k) {
    auto errors = rounded_errors(run.errors.run.col(static_cast<Eigen::Index>(k))),
         baselines = rounded_errors(constant.col(static_cast<Eigen::Index>(k)));
    if (can_matter(baselines, errors))
      columns.values.set(baseline_measure(error_kinds[k]), std::move(baselines));
    columns.values.set(error_measure(error_kinds[k]), std::move(errors));
  }
  for (const Scale scale : error_scales) {
    const Vec& hidden = run.observed.unresolved.at(static_cast<std::size_t>(scale));
    if (hidden.size() != run.values.rows()) continue;
    const auto& errors = *columns.values.find(error_measure({Norm::maximum, scale}));
    auto variations = rounded_errors(hidden);
    if (!std::ranges::equal(variations, errors, std::ranges::less_equal{}))
      columns.values.set(unresolved_measure(scale), std::move(variations));
  }
  return columns;
}

MeasuresOfColumns measures_of_columns(const ColumnErrors& all, const std::vector<std::string>& columns) {
  std::vector<std::size_t> places;
  for (const auto& name : columns) {
    const auto found = std::ranges::find(all.names, name);
    if (found == all.names.end() || all.values.empty()) return {};
    places.push_back(static_cast<std::size_t>(found - all.names.begin()));
  }
  MeasuresOfColumns measures;
  const auto value = [&](std::string_view id) -> std::optional<double> {
    const auto* const found = all.values.find(id);
    return found != nullptr ? std::optional(largest_of(*found, places)) : std::nullopt;
  };
  for (const ErrorKind& kind : error_kinds) {
    const auto error = value(error_measure(kind)), baseline = value(baseline_measure(kind));
    measures[std::string(error_measure(kind))] = error;
    const bool is_useless = error && baseline && *baseline > 0.0 && *baseline <= *error;
    measures[std::string(baseline_measure(kind))] = is_useless ? baseline : std::nullopt;
    if (kind.norm == Norm::end) continue;
    const auto hidden = value(unresolved_measure(kind.scale));
    measures[std::string(unresolved_measure(kind.scale))] =
        error && hidden && *hidden > *error ? hidden : std::nullopt;
  }
  return measures;
}

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
