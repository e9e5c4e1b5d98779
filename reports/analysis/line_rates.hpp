#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/runs.hpp"
#include "observers/rate.hpp"

namespace fde {

// Theoretical and observed rate of one line in one norm. fit.points = 0: too few errors above rounding.
struct NormRate {
  std::optional<double> expected{};
  Fit fit{};

  // observed - expected, where both are known.
  [[nodiscard]] std::optional<double> deviation() const;
};

// The rates of one line, observed over its finest step counts, five at most.
struct RateRow {
  SceneSettings scene;
  std::string scheme;
  Setup setup;
  int coarsest = 0, finest = 0;  // steps
  NormRate end{}, maximum{};
};

RateRow rate_of(RunSpan line);

// How fast a quantity falls with the step, over the same step counts.
Fit observed_rate(RunSpan line, std::string_view quantity);

// A row for each line, in the order of the runs. Schemes that choose their steps have no rate in them.
std::vector<RateRow> rates(const Runs& runs);

}  // namespace fde
