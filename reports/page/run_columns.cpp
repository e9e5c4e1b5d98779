// SPDX-License-Identifier: MIT
#include "fdebench/reports/page/run_columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>

#include "fdebench/benchmarks/records/record_validation.hpp"
#include "fdebench/reports/page/facts.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

// Besides the errors: quantities of charts, and quantities of tooltips only, with fewer digits.
constexpr std::array<std::string_view, 5> drawn{"time_minimum", "time_median", "energy_residual",
                                                "drift_internal", "drift_independent"};
constexpr std::array<std::string_view, 6> cost_names{"rhs_calls",      "newton_iterations",
                                                     "rejected_steps", "history_bytes",
                                                     "rounding",       "reference_bound_maximum"};

// h * steps if it is equal for all runs; otherwise nullopt.
std::optional<double> common_end(const std::vector<const Record*>& runs) {
  std::optional<double> end;
  for (const Record* run : runs) {
    const double end_of_run = run->h() * run->steps;
    if (!end) end = end_of_run;
    if (std::abs(end_of_run - *end) > 1e-9 * *end) return std::nullopt;
  }
  return end;
}

// The quantities of these runs that are no measures of ours.
std::set<std::string> quantities_of_others(const std::vector<const Record*>& runs) {
  std::set<std::string> names;
  for (const Record* run : runs) {
    for (const auto& [quantity, value] : run->values)
      if (!is_measure(quantity)) names.emplace(quantity);
  }
  return names;
}

json requested_tolerance(const Record& run) {
  const auto* accuracy = std::get_if<Tolerance>(&run.key.settings.resolution);
  return accuracy != nullptr ? json(accuracy->rtol) : json();
}

}  // namespace

json run_columns(const PageInput& page, const std::vector<const Record*>& runs) {
  json columns;
  const auto add = [&](const std::string& name, const std::function<json(const Record&)>& of) {
    json column = json::array();
    for (const Record* run : runs) column.push_back(of(*run));
    if (std::ranges::any_of(column, [](const json& value) { return !value.is_null(); }))
      columns[name] = column;
  };
  Places lines;
  add("line", [&](const Record& run) { return json(lines(page.label(run.key))); });
  columns["lines"] = lines.texts();
  add("steps", [](const Record& run) { return json(run.steps); });
  if (const auto end = common_end(runs)) {
    columns["end"] = chart_number(end, 10);
  } else {
    add("h", [](const Record& run) { return chart_number(run.h()); });
  }
  add("requested", requested_tolerance);
  for (const ErrorKind& kind : error_kinds) {
    const auto name = error_measure(kind);
    add(std::string(name), [&](const Record& run) { return chart_number(run[name]); });
  }
  for (const auto name : drawn)
    add(std::string(name), [&](const Record& run) { return chart_number(run[name]); });
  for (const auto name : cost_names)
    add(std::string(name), [&](const Record& run) { return chart_number(run[name], few_digits); });
  for (const auto& name : quantities_of_others(runs))
    add("own " + name, [&](const Record& run) { return chart_number(run[name], few_digits); });
  add("grading", [](const Record& run) {
    return run.key.settings.grading == 1.0 ? json() : json(run.key.settings.grading);
  });
  add("wall_clock", [](const Record& run) { return run.timing.wall_clock ? json(true) : json(); });
  if (page.sessions.size() > 1)
    add("session", [](const Record& run) { return json(run.last_session() + 1); });
  return columns;
}

}  // namespace fde::bench
