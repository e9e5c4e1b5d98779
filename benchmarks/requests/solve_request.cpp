// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/solve_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "fdebench/benchmarks/text/entry_named.hpp"
#include "fdebench/benchmarks/text/refusal.hpp"

namespace fde::bench {

StepsOrTolerance resolution_from(const std::optional<int>& steps, const std::optional<double>& accuracy) {
  if (accuracy) {
    require_in("accuracy", *accuracy, positive);
    return Tolerance{.rtol = *accuracy, .atol = *accuracy};
  }
  if (!steps) throw Refusal({RequestField{"steps"}, " is required"});
  require_in("steps", *steps, step_counts);
  return *steps;
}

OutputTimes output_times_from(std::optional<std::vector<double>> at, const std::optional<int>& every,
                              const std::optional<int>& points) {
  if (std::ranges::count(std::array{at.has_value(), every.has_value(), points.has_value()}, true) > 1) {
    throw Refusal({RequestField{"at"}, ", ", RequestField{"every"}, " and ", RequestField{"points"},
                   ": one of them at most"});
  }
  if (every) {
    require_in("every", *every, step_counts);
    return EveryTime{*every};
  }
  if (points) {
    require_in("points", *points, point_counts);
    return SpreadTimes{*points};
  }
  if (!at) return AllTimes{};
  for (const double t : *at) require_in("at", t, not_negative);
  return GivenTimes{std::move(*at)};
}

std::optional<double> parse_grid(std::string_view text) {
  if (text == optimal_grid) return std::nullopt;
  return parse_grading(text, fmt::format(", or {}", optimal_grid));
}

void set_grid(SolveRequest& request, std::string_view text) {
  const auto grading = parse_grid(text);
  request.optimal_grading = !grading;
  request.settings.grading = grading.value_or(1.0);
}

void require_allowed(const StepsOrTolerance& resolution) {
  if (const auto* steps = std::get_if<int>(&resolution)) return require_in("steps", *steps, step_counts);
  const auto& [rtol, atol] = std::get<Tolerance>(resolution);
  require_in("accuracy", rtol, positive);
  require_in("accuracy", atol, not_negative);
}

void require_allowed(const RunSettings& settings) {
  require_in("grid", settings.grading, gradings);
  require_in("tolerance", settings.newton_tolerance, newton_tolerances);
}

const Scheme& scheme_named(std::string_view id) {
  const Scheme* const found = find_scheme(id);
  return found != nullptr ? *found : entry_by_id(schemes(), "scheme", id);
}

}  // namespace fde::bench
