// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/robustness.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <tuple>

namespace fde::bench {
namespace {

constexpr double deviations = 1.959963984540054;  // of a normal distribution, with 2.5 % beyond
constexpr double beyond = 0.025;

double regret(const std::optional<MedianInterval>& time, double least) {
  return time ? time->median / least : INFINITY;
}

// The column of the least time; nullopt if there is none.
std::optional<std::size_t> quickest(const std::vector<std::optional<MedianInterval>>& times) {
  std::optional<std::size_t> best;
  for (std::size_t line = 0; line < times.size(); ++line) {
    if (times[line] && (!best || times[line]->median < times[*best]->median)) best = line;
  }
  return best;
}

bool is_within_noise(const std::vector<std::optional<MedianInterval>>& times, std::size_t best) {
  for (std::size_t line = 0; line < times.size(); ++line)
    if (line != best && times[line] && times[line]->low <= times[best]->high) return true;
  return false;
}

}  // namespace

Estimate wilson_share(std::size_t k, std::size_t n) {
  const auto of = static_cast<double>(n), some = static_cast<double>(k);
  const double square = deviations * deviations, scale = of + square;
  const double centre = (some + square / 2) / scale;
  const double half = deviations * std::sqrt(some * (of - some) / of + square / 4) / scale;
  return {some / of, std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

Estimate quantile_of(std::vector<double> values, double p, double least) {
  std::ranges::sort(values);
  const auto n = values.size();
  const boost::math::binomial_distribution<double> below(static_cast<double>(n), p);
  const auto up_to = [&](std::size_t rank) { return boost::math::cdf(below, static_cast<double>(rank)); };
  const auto middle = std::clamp<std::size_t>(
      static_cast<std::size_t>(std::ceil(static_cast<double>(n) * p * (1 - 1e-15))), 1, n);
  std::size_t low = middle, high = middle;
  while (low > 0 && up_to(low - 1) > beyond) --low;
  while (high <= n && 1.0 - up_to(high - 1) > beyond) ++high;
  return {values[middle - 1], low > 0 ? values[low - 1] : least, high <= n ? values[high - 1] : INFINITY};
}

Robustness robustness_of(const TimesOfScenes& times) {
  Robustness found;
  const auto columns = times.empty() ? 0 : times.front().size();
  std::vector<LineRobustness> lines(columns);
  std::vector<std::vector<double>> regrets(columns);
  std::vector<std::size_t> near(columns);
  for (const auto& scene : times) {
    const auto best = quickest(scene);
    if (!best) {
      ++found.unsolved;
      continue;
    }
    ++found.scenes;
    if (is_within_noise(scene, *best)) {
      ++found.tied;
    } else {
      ++lines[*best].won;
    }
    for (std::size_t line = 0; line < columns; ++line) {
      regrets[line].push_back(regret(scene[line], scene[*best]->median));
      if (scene[line]) ++lines[line].solved;
      if (regrets[line].back() <= near_factor) ++near[line];
    }
  }
  for (std::size_t line = 0; line < columns; ++line) {
    auto& of = lines[line];
    if (of.solved == 0) continue;
    of.line = line;
    of.near = wilson_share(near[line], found.scenes);
    of.median = quantile_of(regrets[line], 0.5, 1.0);
    of.tail = quantile_of(std::move(regrets[line]), tail_share, 1.0);
    found.lines.push_back(of);
  }
  std::ranges::stable_sort(found.lines, {}, [&](const LineRobustness& of) {
    return std::tuple(of.tail.value, found.scenes - of.solved, of.median.value);
  });
  for (std::size_t other = 1; other < found.lines.size(); ++other) {
    if (found.lines[other].tail.low <= found.lines.front().tail.high)
      found.undecided.push_back(found.lines[other].line);
  }
  return found;
}

}  // namespace fde::bench
