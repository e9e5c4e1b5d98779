// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <limits>
#include <string>
#include <string_view>
#include <variant>

#include "fdebench/schemes/problem/resolution.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

using StepsOrTolerance = std::variant<int, Tolerance>;

// The settings of a run. Scene, scheme and settings identify a run: a sweep performs each run once.
struct RunSettings {
  StepsOrTolerance resolution = 1;
  double grading = 1.0;  // of the grid
  HistoryKind history = HistoryKind::automatic;
  double newton_tolerance = Options{}.newton_tolerance;
  double budget = std::numeric_limits<double>::infinity();  // seconds for each solve

  auto operator<=>(const RunSettings&) const = default;

  [[nodiscard]] Options options() const;
};

// The grid up to `end`, or the tolerance, for the scheme.
Resolution resolution_of(const RunSettings& settings, double end);

// Whether two settings differ at most in the number of steps or in the tolerance: their runs form one line of
// a chart.
bool same_series(RunSettings a, const RunSettings& b);

// "uniform" or "graded:R"; "N = 64" or "accuracy 1e-6, 1e-9".
std::string grid_text(double grading);
std::string resolution_text(const RunSettings& settings);

// The grading from "uniform" or "graded:R"; the history from "auto", "direct" or "exponentials". Each throws
// Refusal naming the field, the text and what is allowed: of a grid also what is `allowed_besides`.
double parse_grading(std::string_view text, std::string_view allowed_besides = "");
HistoryKind parse_history(std::string_view text);

}  // namespace fde::bench
