// SPDX-License-Identifier: MIT
#include "fdebench/reports/page/facts.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>

#include "fdebench/benchmarks/text/rounded_number.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

constexpr int digits_of_facts = 8;
constexpr double largest_exact = 9e15;  // every whole number up to it is a double

bool is_missing(const json& value) {
  if (const auto* text = value.get_ptr<const std::string*>()) return text->empty();
  return value.is_null() || value == false || (value.is_structured() && value.empty());
}

}  // namespace

json fact(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return {};
  if (*value == std::trunc(*value) && std::abs(*value) < largest_exact)
    return static_cast<std::int64_t>(*value);
  return rounded(*value, digits_of_facts);
}

json chart_number(const std::optional<double>& value, int digits) {
  return value ? json(rounded(*value, digits)) : json();
}

json compact(json value) {
  if (value.is_array()) {
    for (json& element : value) element = compact(std::move(element));
  } else if (value.is_object()) {
    for (auto member = value.begin(); member != value.end();) {
      *member = compact(std::move(*member));
      member = is_missing(*member) ? value.erase(member) : std::next(member);
    }
  }
  return value;
}

json session_number(const PageInput& page, std::size_t index) {
  return page.sessions.size() > 1 ? json(index + 1) : json();
}

json ending_facts(const RunOutcome& outcome) {
  return {{"ending", name(outcome.kind)}, {"detail", outcome.detail}};
}

json run_facts(const PageInput& page, const Record& run, std::initializer_list<std::string_view> quantities) {
  json facts{{"line", page.label(run.key)},
             {"grid", page.grid(run.key.settings)},
             {"steps", run.steps},
             {"wall_clock", run.timing.wall_clock}};
  for (const auto quantity : quantities) facts[std::string(quantity)] = fact(run[quantity]);
  return facts;
}

json run_facts(const PageInput& page, const RecommendedRun& option) {
  const auto* requested = std::get_if<Tolerance>(&option.settings.resolution);
  const auto& [median, low, high, confidence] = option.time;
  const bool is_timed = median > 0.0;
  json facts{{"line", page.label(option)},      {"grid", page.grid(option.settings)},
             {"steps", option.steps},           {"error", fact(option.error)},
             {"wall_clock", option.wall_clock}, {"session", session_number(page, option.session)}};
  if (requested != nullptr) facts["requested"] = fact(requested->rtol);
  if (is_timed) facts.update({{"seconds", fact(median)}, {"low", fact(low)}, {"high", fact(high)}});
  if (is_timed && option.setup_seconds > 0.0) {
    if (option.first_run) {
      facts["later_seconds"] = fact(option.later_run_seconds());
    } else {
      facts["first_seconds"] = fact(option.first_run_seconds());
    }
  }
  return facts;
}

}  // namespace fde::bench
