#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/line_names.hpp"
#include "analysis/runs.hpp"
#include "analysis/verdict.hpp"

namespace fde {

// A run that two sets of results have.
struct CommonRun {
  const MeasuredRun *before, *now;
};

// The ratio of two times, now to before, and between which it is by the intervals of both medians. What
// differs between two sessions as a whole (another load, another clock) is not in these.
struct TimeRatio {
  CommonRun run;
  TimeSpread before{}, now{};
  double ratio = 1.0;  // of the medians
  double low = 1.0, high = 1.0;

  [[nodiscard]] bool slower() const { return low > 1.0; }
  [[nodiscard]] bool faster() const { return high < 1.0; }
};

// An error that moved: by more than a hundredth, and by more than what is not known of it. That is four times
// the measured `rounding`, which is one sample of what rounding does, and the bound of the reference, in the
// scale of the error: both are absolute and at the end, so an error of another scale takes its part of them.
struct MovedError {
  CommonRun run;
  std::string_view quantity;
  double before = 0.0, now = 0.0;

  [[nodiscard]] bool grew() const { return now > before; }
};

// A run that ends in another way, or has another verdict. A verdict falls from `survives` or `stops rightly`
// to anything else, and from `inaccurate`, `refuses` or `not judged` to `fails`.
struct ChangedEnding {
  CommonRun run;
  Verdict before, now;

  [[nodiscard]] bool fell() const;
};

// What two sets of results say of the runs that both have, the worst first.
struct Comparison {
  std::size_t common = 0, only_before = 0, only_now = 0;  // runs
  std::size_t timed_before = 0;                           // runs of both that only the first has timed
  std::vector<TimeRatio> times{};                         // of all runs that both have timed
  std::vector<MovedError> errors{};
  std::vector<ChangedEnding> endings{};

  // Whether an error grew or a verdict fell.
  [[nodiscard]] bool is_worse() const;

  // How many runs take more than this many times as long, by the least ratio that the spreads of their
  // repeats leave open.
  [[nodiscard]] std::ptrdiff_t slower_than(double factor) const;

  // Whether the second has all runs and times of the first.
  [[nodiscard]] bool has_all() const { return only_before == 0 && timed_before == 0; }
};

// Runs are the same where scene, scheme and setup are. The comparison points into them. Errors are all
// quantities whose names begin with error_; of those of a run that moved it has the worst.
Comparison compare(const Runs& before, const Runs& now);

// As lines of text: a table of each kind of change, its first rows, and sums.
std::string comparison_text(const Comparison& comparison, const LineNames& names);

}  // namespace fde
