// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/reports/analysis/line_names.hpp"
#include "fdebench/reports/analysis/runs.hpp"
#include "fdebench/reports/analysis/trial_result.hpp"

namespace fde::bench {

// A run that is in both sets of results.
struct CommonRun {
  const Record *before, *now;
};

// The ratio of two times, now / before, with the interval that follows from the intervals of both medians. A
// difference between the sessions as a whole (load, clock frequency) is not included.
struct TimeRatio {
  CommonRun run;
  MedianInterval before{}, now{};
  double ratio = 1.0;  // of the medians
  double low = 1.0, high = 1.0;

  [[nodiscard]] bool slower() const { return low > 1.0; }
  [[nodiscard]] bool faster() const { return high < 1.0; }
};

// An error that changed by more than 1 % and by more than its uncertainty: four times the measured `rounding`
// (one sample of the effect of rounding) plus the bound of the reference. Both are absolute and at the end;
// for an error of another kind they are multiplied by its ratio to the absolute error at the end.
struct ErrorChange {
  CommonRun run;
  std::string_view quantity;
  double before = 0.0, now = 0.0;

  [[nodiscard]] bool grew() const { return now > before; }
};

// A run with another ending or another verdict. A verdict falls from `survives` or `stops rightly` to any
// other, and from `inaccurate`, `refuses` or `not judged` to `fails`.
struct EndingChange {
  CommonRun run;
  TrialResult before, now;

  [[nodiscard]] bool is_worse() const;
};

// The comparison of two sets of results over their common runs, each list sorted from the worst change on.
struct Comparison {
  std::size_t common = 0, only_before = 0, only_now = 0;  // runs
  std::size_t timed_before = 0;                           // common runs with a time in the first set only
  std::size_t unlike = 0;  // common runs whose errors are over other columns in each set: not compared
  std::vector<TimeRatio> times{};  // of all runs with a time in both sets
  std::vector<ErrorChange> errors{};
  std::vector<EndingChange> endings{};

  // Whether an error grew or a verdict got worse.
  [[nodiscard]] bool is_worse() const;

  // The number of runs whose time grew by more than `factor`, by the lower end of the interval of the ratio.
  [[nodiscard]] std::ptrdiff_t slower_than(double factor) const;

  // Whether the second set contains all runs and times of the first.
  [[nodiscard]] bool has_all() const { return only_before == 0 && timed_before == 0; }
};

// Runs are equal if scene, scheme and settings are. Compares all quantities whose names begin with error_ and
// lists the worst change of each run. `before` and `now` must outlive the result, which points into them.
Comparison compare(const Runs& before, const Runs& now);

// Text with a table of each kind of change (its first rows) and totals.
std::string comparison_text(const Comparison& comparison, const LineNames& names);

}  // namespace fde::bench
