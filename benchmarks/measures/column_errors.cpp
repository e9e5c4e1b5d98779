// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/column_errors.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "fdebench/benchmarks/text/rounded_number.hpp"

namespace fde::bench {
namespace {

constexpr int digits_of_errors = 4;

// Of each column alone, by a function of the rows of its values, reference and divisors.
template <class Function>
std::vector<double> of_columns(const FinishedRun& run, const Rows& by, const Function& of_column) {
  std::vector<double> values;
  for (Eigen::Index i = 0; i < run.values.rows(); ++i) {
    values.push_back(
        rounded(of_column(i, Rows(run.values.row(i)), Rows(run.reference.row(i)), Rows(by.row(i))),
                digits_of_errors));
  }
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

}  // namespace

ColumnErrors column_errors(const FinishedRun& run, std::vector<std::string> names, bool is_part) {
  ColumnErrors columns{.names = std::move(names), .is_part = is_part};
  if (columns.names.size() > most_single_columns || run.reference.cols() == 0) return columns;
  const auto& times = run.path.times;
  const bool from_start = times.size() > 1 && times.front() == 0.0;
  for (const ErrorKind& kind : error_kinds) {
    const Rows by = divisors(kind.scale, times, run.reference);
    auto errors =
        of_columns(run, by, [&](auto, const Rows& values, const Rows& reference, const Rows& divisor) {
          return error_of(kind.norm, values, reference, divisor);
        });
    auto baselines =
        of_columns(run, by, [&](auto i, const Rows&, const Rows& reference, const Rows& divisor) {
          if (from_start && is_constant(reference, run.reference_bounds.row(i))) return 0.0;
          return constant_solution_error(kind.norm, times, reference, divisor);
        });
    if (can_matter(baselines, errors))
      columns.values[std::string(baseline_measure(kind))] = std::move(baselines);
    columns.values[std::string(error_measure(kind))] = std::move(errors);
  }
  for (const Scale scale : error_scales) {
    const Vec& hidden = run.observed.unresolved.at(static_cast<std::size_t>(scale));
    if (hidden.size() != run.values.rows()) continue;
    const auto& errors = columns.values[std::string(error_measure({Norm::maximum, scale}))];
    std::vector<double> variations;
    for (const double value : hidden) variations.push_back(rounded(value, digits_of_errors));
    if (!std::ranges::equal(variations, errors, std::ranges::less_equal{}))
      columns.values[std::string(unresolved_measure(scale))] = std::move(variations);
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
    const auto found = all.values.find(std::string(id));
    return found == all.values.end() ? std::nullopt : std::optional(largest_of(found->second, places));
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

}  // namespace fde::bench
