// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/record_validation.hpp"

#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>
#include <variant>

#include "fdebench/benchmarks/measures/measures.hpp"
#include "fdebench/benchmarks/records/well_formed.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {
namespace {

// The unit and the allowed values of a measure.
struct Quantity {
  std::string_view unit;
  Range range = not_negative;
};

// The measure with this id; nullptr if this build does not have it.
const Quantity* find_quantity(std::string_view id) {
  static const auto all = [] {
    std::map<std::string_view, Quantity> known;
    for (const auto* measure : measures())
      known[measure->id] = {measure->unit, measure->may_be_negative ? any_number : not_negative};
    for (const auto& measure : time_measures()) known[measure.id] = {measure.unit};
    return known;
  }();
  const auto found = all.find(id);
  return found == all.end() ? nullptr : &found->second;
}

Range range_of(std::string_view quantity) {
  if (const auto* known = find_quantity(quantity)) return known->range;
  require_name("quantity", quantity);
  return any_number;
}

void require_values(const QuantityValues& values) {
  for (const auto& [quantity, value] : values) require_in(quantity, value, range_of(quantity));
}

void require_columns(const ColumnErrors& columns) {
  for (const auto& name : columns.names) require_name("columns", name);
  for (const auto& [quantity, values] : columns.values) {
    require_name("columns", quantity);
    require_length("columns", values.size(), columns.names.size());
    for (const double value : values) require_in(quantity, value, not_negative);
  }
}

void require_course(std::string_view quantity, const Course& course) {
  const Range range = range_of(quantity);
  require_times("course", course.t);
  require_length("course", course.value.size(), course.t.size());
  for (const double value : course.value) require_in(quantity, value, range);
}

void require_program(const Record& run) {
  if (run.program != ProgramFacts{} && !run.key.external)
    throw std::invalid_argument("program: is allowed in runs of other programs only");
  for (const auto& [field, text] : {std::pair("code", run.program.code),
                                    {"version", run.program.version},
                                    {"language", run.program.language}})
    if (!text.empty()) require_name(field, text);
}

void require_key(const RunKey& run) {
  require_scene(run.scene);
  if (run.external) {
    require_external_name("scheme", run.scheme);
  } else {
    require_name("scheme", run.scheme);
  }
  if (const auto* accuracy = std::get_if<Tolerance>(&run.settings.resolution)) {
    require_in("accuracy", accuracy->rtol, not_negative);
    require_in("accuracy", accuracy->atol, not_negative);
  }
  require_in("tolerance", run.settings.newton_tolerance, {.low = 0.0, .high = 1.0});
  if (std::isfinite(run.settings.budget)) require_in("budget", run.settings.budget, positive);
}

void require_timing(const Timing& timing, bool external) {
  require_values(timing.values);
  if (timing.wall_clock && !external)
    throw std::invalid_argument("wall_clock: is allowed in times of other programs only");
}

}  // namespace

std::string_view unit_of(std::string_view quantity) {
  const auto* known = find_quantity(quantity);
  return known == nullptr ? "" : known->unit;
}

bool is_measure(std::string_view quantity) { return find_quantity(quantity) != nullptr; }

void require_external_name(std::string_view name, std::string_view text) {
  require_name(name, text);
  if (find_scheme(text) != nullptr) reject_text(name, text, "another name than those of our schemes");
}

void require_valid(const Record& run) {
  require_key(run.key);
  require_in("end", run.end, not_negative);
  require_name("ending", name(run.ending.kind));
  require_in("ended_at", run.ended_at, not_negative);
  require_program(run);
  require_columns(run.columns);
  require_values(run.values);
  for (const auto& [quantity, course] : run.courses) require_course(quantity, course);
  require_timing(run.timing, run.key.external);
}

void require_valid(const LaterTimes& times) {
  require_key(times.key);
  require_timing(times.timing, times.key.external);
}

}  // namespace fde::bench
