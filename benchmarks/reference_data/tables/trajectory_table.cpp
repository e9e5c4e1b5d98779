// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "fdebench/benchmarks/reference_data/table_comparison.hpp"
#include "fdebench/benchmarks/reference_data/table_kind.hpp"
#include "fdebench/benchmarks/references/decimal_bound.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"

namespace fde::bench {
namespace {

constexpr int least_digits = 8;           // of a reference in double, for a check to be meaningful
constexpr std::size_t most_columns = 32;  // wider tables are unreadable
constexpr double latest_time = 1000.0;

constexpr std::array stated_times{0.0,  0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1,  0.2,
                                  0.5,  1.0,   1.5,   2.0,   3.0,  4.0,  5.0,  7.0,  10.0,
                                  12.0, 15.0,  20.0,  25.0,  30.0, 35.0, 40.0, 45.0, 50.0};

std::string method_of(const Scene& scene) {
  if (scene.reference.digits) {
    return "closed form, or inverse Laplace transform with residues and a contour at two resolutions, in "
           "multiple precision; parameters and times are taken as the decimals they are";
  }
  if (scene.reference.at) return "closed form, in double";
  return "piecewise collocation on a graded mesh, in double; the error is estimated from a second resolution "
         "and a second method, exponentials of the memory with Radau IIA";
}

TableMetadata trajectory_facts(const SceneVariant& of) {
  const Scene scene = make_scene(of);
  const bool exact = static_cast<bool>(scene.reference.digits);
  TableMetadata facts{
      .title = fmt::format("{}: the solution at stated times", of.factory->title),
      .method = method_of(scene),
      .source = std::string(of.factory->source),
      .bound = scene.reference.at
                   ? "the largest over the columns, of the absolute error, the rounding of the texts included"
                   : "an estimate, the largest over the columns, of the absolute error",
      .digits = exact ? table_digits : double_digits,
      .columns = {{.name = "t", .description = "time", .argument = true, .minimum = 0}}};
  for (const auto& name : scene.outputs.names) {
    facts.columns.push_back(
        {.name = name, .description = fmt::format("{} of the scene at t", name), .required = false});
  }
  facts.columns.push_back(
      {.name = "bound", .description = "bound of the absolute error", .required = false, .minimum = 0});
  return facts;
}

// The columns of the solution, with the requested digits if there is an exact solution, otherwise in double.
class ReferenceColumns {
 public:
  ReferenceColumns(const SceneVariant& of, double end) : scene_(make_scene(of)) {
    if (!is_two_sided(scene_.problem)) scene_.problem.end = end;
    if (!scene_.reference.digits) reference_ = reference_of(scene_);
  }

  [[nodiscard]] std::vector<reference::Decimal> at(double t, int digits) const {
    auto columns = scene_.reference.digits ? scene_.reference.digits(t, digits) : evaluate_in_double(t);
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (columns[c].bound == "inf" || columns[c].bound == "nan")
        throw std::runtime_error(fmt::format("{} is not finite at t = {}", scene_.outputs.names[c], t));
    }
    return columns;
  }

  // A two-sided problem has no solution after the end of its interval.
  [[nodiscard]] bool is_defined_at(double t) const {
    return !is_two_sided(scene_.problem) || t <= scene_.problem.end;
  }
  [[nodiscard]] bool has_digits() const { return static_cast<bool>(scene_.reference.digits); }
  [[nodiscard]] const std::vector<std::string>& names() const { return scene_.outputs.names; }

 private:
  // The shortest decimal that identifies the double; the bound includes its rounding, two digits rounded up.
  [[nodiscard]] std::vector<reference::Decimal> evaluate_in_double(double t) const {
    constexpr double half_ulp = 0x1p-53;
    const auto [value, bound] = reference_.at(t);
    std::vector<reference::Decimal> decimals;
    for (Eigen::Index i = 0; i < value.size(); ++i) {
      const double whole = t == 0.0 ? bound[i] : bound[i] + half_ulp * std::abs(value[i]);
      decimals.push_back({fmt::format("{}", value[i]), bound_text(whole)});
    }
    return decimals;
  }

  Scene scene_;
  reference::Reference reference_{};
};

std::string largest_bound(const std::vector<reference::Decimal>& columns) {
  std::string largest = "0";
  for (const auto& column : columns) largest = larger_bound(largest, column.bound);
  return largest;
}

ComputedTable trajectory_rows(const SceneVariant& of) {
  const ReferenceColumns reference(of, stated_times.back());
  ComputedTable made;
  for (const auto& column : trajectory_facts(of).columns) made.table.columns.push_back(column.name);
  for (const double t : stated_times) {
    if (!reference.is_defined_at(t)) break;
    const auto columns = reference.at(t, table_digits);
    std::vector<std::string> row{fmt::format("{}", t)};
    for (const auto& column : columns) row.push_back(column.value);
    row.push_back(largest_bound(columns));
    made.table.rows.push_back(std::move(row));
  }
  return made;
}

std::vector<double> times_of(const DataTable& given) {
  std::vector<double> times;
  const auto column = *given.find("t");
  for (std::size_t row = 0; row < given.rows.size(); ++row) {
    const auto& text = given.rows[row][column];
    double t = -1.0;
    if (decimal_precision(text)) std::from_chars(text.data(), text.data() + text.size(), t);
    if (!(t >= 0.0 && t <= latest_time)) {
      throw InvalidTable(
          fmt::format("{}: {} must be a time in [0, {}]", given.place(row, "t"), text, latest_time));
    }
    times.push_back(t);
  }
  return times;
}

RowCheck trajectory_check(const SceneVariant& of, const DataTable& given) {
  const auto times = times_of(given);
  const double end = times.empty() ? 0.0 : std::ranges::max(times);
  const auto reference = std::make_shared<ReferenceColumns>(of, end > 0.0 ? end : 1.0);
  const auto comparison = std::make_shared<TableComparison>(given, reference->names());
  return [=](std::size_t row) {
    const auto recomputed = reference->at(times[row], comparison->digits() + more_digits);
    comparison->require_accurate(
        row, recomputed,
        reference->has_digits() ? comparison->digits() : std::min(comparison->digits(), least_digits));
    return (*comparison)(row, recomputed);
  };
}

bool has_table(const SceneVariant& of) {
  return make_scene(*of.factory, of.values).outputs.names.size() <= most_columns;
}

}  // namespace

const TableKind trajectory_table{.id = "trajectory",
                                 .folder = "trajectories",
                                 .identifying_column = "t",
                                 .facts = trajectory_facts,
                                 .make = trajectory_rows,
                                 .check = trajectory_check,
                                 .has_table = has_table};

}  // namespace fde::bench
