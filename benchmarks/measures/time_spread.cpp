// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/time_spread.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fde::bench {

MedianInterval spread_of(std::vector<double> seconds) {
  constexpr double half_width = 0.98;  // 1.96 standard deviations of a binomial number, each sqrt(n) / 2
  constexpr std::size_t fewest = 6;
  std::ranges::sort(seconds);
  const auto last = static_cast<double>(seconds.size() - 1);
  const auto at = [&](double rank) { return seconds[static_cast<std::size_t>(std::clamp(rank, 0.0, last))]; };
  const double median = 0.5 * (at(std::floor(last / 2)) + at(std::ceil(last / 2)));
  if (seconds.size() < fewest) return {median, seconds.front(), seconds.back()};
  const double ranks = half_width * std::sqrt(last + 1.0);
  return {median, at(std::floor(last / 2 - ranks)), at(std::ceil(last / 2 + ranks))};
}

}  // namespace fde::bench
