// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/line_rates.hpp"

#include <algorithm>
#include <variant>

namespace fde::bench {
namespace {

constexpr std::size_t most_fitted = 5;

RunSpan finest(RunSpan line) { return line.last(std::min(line.size(), most_fitted)); }

NormRate norm_rate(RunSpan runs, std::string_view error, std::string_view expected) {
  return {.expected = runs.back()[expected], .fit = observed_rate(runs, error)};
}

}  // namespace

std::optional<double> NormRate::deviation() const {
  if (!expected || fit.points == 0) return std::nullopt;
  return fit.slope - *expected;
}

Fit observed_rate(RunSpan line, std::string_view quantity) {
  std::vector<ErrorSample> points;
  for (const Record& run : finest(line)) {
    const auto value = run[quantity];
    if (value && run.h() > 0.0) points.push_back({run.h(), *value});
  }
  return fit_rate(points);
}

RateRow rate_of(RunSpan line) {
  const RunSpan fitted = finest(line);
  const RunKey& key = fitted.back().key;
  return {.scene = key.scene,
          .scheme = key.scheme,
          .settings = key.settings,
          .coarsest = fitted.front().steps,
          .finest = fitted.back().steps,
          .end = norm_rate(fitted, "error_end", "expected_rate_end"),
          .maximum = norm_rate(fitted, "error_maximum", "expected_rate_maximum")};
}

std::vector<RateRow> rates(const Runs& runs) {
  std::vector<RateRow> rows;
  for (const RunSpan line : by_line(runs.finished)) {
    if (!std::holds_alternative<Tolerance>(line.front().key.settings.resolution))
      rows.push_back(rate_of(line));
  }
  return rows;
}

}  // namespace fde::bench
