// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "fdebench/benchmarks/measures/timing_conditions.hpp"

namespace fde::bench {

// An estimate with its 95 % confidence interval. It may be infinite.
struct Estimate {
  double value = 0.0, low = 0.0, high = 0.0;
};

// The share k / n with Wilson's interval, z = 1.96:
//   (k + z^2/2 -+ z sqrt(k (n - k) / n + z^2/4)) / (n + z^2)
// E. B. Wilson, Probable inference, the law of succession, and statistical inference, J. Amer. Statist.
// Assoc. 22 (1927). Precondition: k <= n, n > 0.
Estimate wilson_share(std::size_t k, std::size_t n);

// The p-quantile x_(ceil(n p)) of the values, where x_(1) <= ... <= x_(n), with the interval x_(l) to x_(u)
// of order statistics that holds for every distribution: with B ~ binomial(n, p), l is the largest rank with
// P(B < l) <= 2.5 %, u the smallest with P(B >= u) <= 2.5 %. Without such an l the interval begins at
// `least`, without such a u it is infinite. G. J. Hahn, W. Q. Meeker, Statistical Intervals (1991), section
// 5.2. Preconditions: there is a value, 0 < p < 1.
Estimate quantile_of(std::vector<double> values, double p, double least);

// A line on the scenes that some line solves.
struct LineRobustness {
  std::size_t line = 0;    // column of the times
  std::size_t solved = 0;  // scenes
  std::size_t won = 0;     // it is the quickest, and no interval of another meets its own
  Estimate near{};         // share of scenes in which it takes at most near_factor times the least time
  // Quantiles of its regret, its time over the least on the scene, infinite where it does not solve it.
  Estimate median{}, tail{};
};

inline constexpr double near_factor = 1.2;
inline constexpr double tail_share = 0.95;

// How lines compare over scenes, as if the scenes were drawn independently.
struct Robustness {
  std::size_t scenes = 0;    // solved by some line
  std::size_t unsolved = 0;  // by none
  std::size_t tied = 0;      // the quickest is within noise of another
  // By `tail`, then by the number of solved scenes, then by `median`: the first is the best to take without
  // knowing the scene, if its `tail` is finite.
  std::vector<LineRobustness> lines{};
  // The lines after the first whose interval of `tail` meets that of the first.
  std::vector<std::size_t> undecided{};
};

// times[i][j]: of line j on scene i; nullopt where it does not solve it. Lines that solve no scene are left
// out.
using TimesOfScenes = std::vector<std::vector<std::optional<MedianInterval>>>;
Robustness robustness_of(const TimesOfScenes& times);

}  // namespace fde::bench
