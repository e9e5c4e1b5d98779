// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/observers/rate.hpp"
#include "fdebench/reports/analysis/runs.hpp"

namespace fde::bench {

// Theoretical and observed rate of one line in one norm. fit.points = 0: too few errors above rounding.
struct NormRate {
  std::optional<double> expected{};
  Fit fit{};

  // observed - expected, where both are known.
  [[nodiscard]] std::optional<double> deviation() const;
};

// The rates of one line, observed over its finest numbers of steps, at most five.
struct RateRow {
  SceneSettings scene;
  std::string scheme;
  RunSettings settings;
  int coarsest = 0, finest = 0;  // steps
  NormRate end{}, maximum{};
};

// Precondition: the line is not empty.
RateRow rate_of(RunSpan line);

// The observed rate of a quantity with respect to the step size, over the same numbers of steps.
Fit observed_rate(RunSpan line, std::string_view quantity);

// One row per line, in the order of the runs. Lines with adaptive step size are left out: they have no rate.
std::vector<RateRow> rates(const Runs& runs);

}  // namespace fde::bench
