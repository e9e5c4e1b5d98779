// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/record_validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <variant>
#include <vector>

#include "fdebench/benchmarks/measures/measures.hpp"
#include "fdebench/benchmarks/records/well_formed.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {
namespace {

// The quantities of this build, with their units and allowed values.
struct Quantity {
  std::string_view id, unit;
  Range range = not_negative;
};

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all = [] {
    std::vector<Quantity> found{{"ending", "t"}};
    for (const auto* measure : measures())
      found.push_back({measure->id, measure->unit, measure->may_be_negative ? any_number : not_negative});
    for (const auto& measure : time_measures()) found.push_back({measure.id, measure.unit});
    return found;
  }();
  return all;
}

// The range of values of a quantity; any number if this build does not have the quantity.
Range range_of(const Record& row) {
  const auto found = std::ranges::find(quantities(), row.quantity, &Quantity::id);
  if (found == quantities().end()) {
    require_name("quantity", row.quantity);
    require_printable("unit", row.unit);
    return any_number;
  }
  if (row.unit != found->unit)
    reject_text("unit", row.unit, fmt::format("\"{}\", that of {}", found->unit, row.quantity));
  return found->range;
}

void require_quantity(const Record& row) {
  const Range range = range_of(row);
  require_in(row.quantity, row.value, range);
  if (row.ending.has_value() != (row.quantity == "ending"))
    throw std::invalid_argument("ending: must be that of the quantity ending, and of no other");
  if (row.ending) require_name("ending", name(row.ending->kind));
  if (row.program != ProgramFacts{} && (!row.key.external || !row.ending))
    throw std::invalid_argument("program: is allowed in endings of other programs only");
  for (const auto& [field, text] : {std::pair("code", row.program.code),
                                    {"version", row.program.version},
                                    {"language", row.program.language}})
    if (!text.empty()) require_name(field, text);
  require_times("course", row.course.t);
  require_length("course", row.course.value.size(), row.course.t.size());
  for (const double value : row.course.value) require_in(row.quantity, value, range);
}

void require_column_errors(const Record& row) {
  const ColumnErrors& columns = row.columns;
  if (columns != ColumnErrors{} && !row.ending)
    throw std::invalid_argument("columns: are allowed in endings only");
  for (const auto& name : columns.names) require_name("columns", name);
  for (const auto& [quantity, values] : columns.values) {
    require_name("columns", quantity);
    require_length("columns", values.size(), columns.names.size());
    for (const double value : values) require_in(quantity, value, not_negative);
  }
}

void require_setup(const Record& row) {
  const RunSettings& setup = row.key.setup;
  if (const auto* accuracy = std::get_if<Tolerance>(&setup.resolution)) {
    require_in("accuracy", accuracy->rtol, not_negative);
    require_in("accuracy", accuracy->atol, not_negative);
  }
  require_in("h", row.h, not_negative);
  require_in("tolerance", setup.tolerance, {.low = 0.0, .high = 1.0});
  if (std::isfinite(setup.budget)) require_in("budget", setup.budget, positive);
}

}  // namespace

void require_external_name(std::string_view name, std::string_view text) {
  require_name(name, text);
  if (find_scheme(text) != nullptr) reject_text(name, text, "another name than those of our schemes");
}

void require_valid(const Record& row) {
  require_scene(row.key.scene);
  if (row.key.external) {
    require_external_name("scheme", row.key.scheme);
  } else {
    require_name("scheme", row.key.scheme);
  }
  require_setup(row);
  require_quantity(row);
  require_column_errors(row);
  if (row.wall_clock && (!row.key.external || !is_time(row)))
    throw std::invalid_argument("wall_clock: is allowed in times of other programs only");
}

}  // namespace fde::bench
