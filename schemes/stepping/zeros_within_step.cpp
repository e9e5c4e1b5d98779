// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/zeros_within_step.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>

namespace fde {
namespace {

// The distance of a sample from the parabola through three others.
double off_parabola(const TimedValue& sample, const TimedValue& a, const TimedValue& b, const TimedValue& c) {
  const auto part = [&](const TimedValue& of, const TimedValue& one, const TimedValue& other) {
    return of.value * ((sample.t - one.t) / (of.t - one.t)) * ((sample.t - other.t) / (of.t - other.t));
  };
  return std::abs(part(a, b, c) + part(b, a, c) + part(c, a, b) - sample.value);
}

// For each sample whether the interval to its left must be halved. The intervals around a sample are halved
// where its distance from the parabola through three neighbours is more than 1/10 of the range of the values
// and more than 1/4 of the nearest |value|, so that a zero may be missed. If this holds for more than a
// quarter of the intervals, all are halved: the others may look smooth by chance.
std::vector<bool> unresolved(const std::vector<TimedValue>& samples) {
  constexpr double smooth = 0.1, may_hide = 0.25;
  constexpr std::size_t many = 4;  // 1/4 of the intervals
  std::vector<bool> halve(samples.size(), false);
  if (samples.size() < 4) return halve;
  for (std::size_t k = 1; k + 1 < samples.size(); ++k) {
    const std::size_t first = std::min(k < 2 ? 0 : k - 2, samples.size() - 4), last = first + 3;
    std::vector<TimedValue> others(samples.begin() + static_cast<std::ptrdiff_t>(first),
                                   samples.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    const auto [low, high] = std::ranges::minmax(others, {}, &TimedValue::value);
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k - first));
    const double off = off_parabola(samples[k], others[0], others[1], others[2]);
    const double nearest = std::min(
        {std::abs(samples[k - 1].value), std::abs(samples[k].value), std::abs(samples[k + 1].value)});
    // False where a value is not a number.
    if (!(off > smooth * (high.value - low.value) && off > may_hide * nearest)) continue;
    for (std::size_t piece = first + 1; piece <= last; ++piece) halve[piece] = true;
  }
  if (static_cast<std::size_t>(std::ranges::count(halve, true)) * many > halve.size())
    std::fill(halve.begin() + 1, halve.end(), true);
  return halve;
}

std::vector<TimedValue> halved(const ValueAt& value, const std::vector<TimedValue>& samples,
                               const std::vector<bool>& halve) {
  std::vector<TimedValue> more;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (halve[k]) {
      const double t = samples[k - 1].t + (samples[k].t - samples[k - 1].t) / 2.0;
      if (t > samples[k - 1].t && t < samples[k].t) more.push_back({t, value(t)});
    }
    more.push_back(samples[k]);
  }
  return more;
}

// A sample at the minimum of |value| between two samples of equal sign that enclose it. If the function has
// two zeros there, the sample has the opposite sign.
TimedValue beyond(const ValueAt& value, const TimedValue& before, const TimedValue& behind) {
  constexpr int bits = 26;  // a minimum is determined to half of the digits only
  std::uintmax_t evaluations = 100;
  const double sign = std::copysign(1.0, before.value);
  const auto [at, least] = boost::math::tools::brent_find_minima([&](double t) { return sign * value(t); },
                                                                 before.t, behind.t, bits, evaluations);
  return {at, sign * least};
}

bool opposite(const TimedValue& one, const TimedValue& other) { return one.value * other.value < 0.0; }

bool are_on_one_side(const TimedValue& a, const TimedValue& b, const TimedValue& c) {
  return a.value * b.value > 0.0 && b.value * c.value > 0.0;
}

double size_of(const TimedValue& sample) { return std::abs(sample.value); }

bool has_least_size(const TimedValue& before, const TimedValue& now, const TimedValue& behind) {
  return are_on_one_side(before, now, behind) && size_of(now) < size_of(before) &&
         size_of(now) <= size_of(behind);
}

// Whether the parabola through the first or last sample and the next two, of which it is the smallest, has
// its least size between it and the next one.
bool turns_next_to(const TimedValue& end, const TimedValue& next, const TimedValue& other) {
  if (!are_on_one_side(end, next, other) || size_of(end) > size_of(next)) return false;
  const double slope = (next.value - end.value) / (next.t - end.t),
               beyond_next = (other.value - next.value) / (other.t - next.t),
               curvature = (beyond_next - slope) / (other.t - end.t);
  return (slope - curvature * (next.t - end.t)) * (next.t - end.t) * end.value < 0.0;
}

}  // namespace

void resolve(const ValueAt& value, std::vector<TimedValue>& samples, std::uint64_t& left) {
  constexpr int most_halvings = 24;
  constexpr std::uint64_t most = 20000;
  for (int round = 0; round < most_halvings && samples.size() < std::min(most, left); ++round) {
    auto more = halved(value, samples, unresolved(samples));
    if (more.size() == samples.size()) return;
    left -= std::min<std::uint64_t>(left, more.size() - samples.size());
    samples = std::move(more);
  }
}

std::vector<std::pair<TimedValue, TimedValue>> sign_changes(const ValueAt& value,
                                                            const std::vector<TimedValue>& samples) {
  std::vector<std::pair<TimedValue, TimedValue>> found;
  const auto add_between = [&](const TimedValue& before, const TimedValue& behind) {
    const TimedValue there = beyond(value, before, behind);
    if (!opposite(before, there)) return;
    found.emplace_back(before, there);
    found.emplace_back(there, behind);
  };
  const std::size_t last = samples.size() - 1;
  if (last > 1 && turns_next_to(samples[0], samples[1], samples[2])) add_between(samples[0], samples[1]);
  TimedValue sided = samples.front();  // the last sample that is finite and not 0
  for (std::size_t k = 1; k <= last; ++k) {
    const TimedValue& now = samples[k];
    if (opposite(sided, now)) found.emplace_back(sided, now);
    if (now.value != 0.0 && std::isfinite(now.value)) sided = now;
    if (k < last && has_least_size(samples[k - 1], now, samples[k + 1]))
      add_between(samples[k - 1], samples[k + 1]);
  }
  if (last > 1 && turns_next_to(samples[last], samples[last - 1], samples[last - 2]))
    add_between(samples[last - 1], samples[last]);
  return found;
}

std::optional<double> time_on_other_side(const Problem& problem, const std::vector<bool>& sides,
                                         const std::vector<double>& times,
                                         const std::function<Vec(double t)>& y, std::uint64_t& left) {
  std::vector<Vec> states;
  for (const double t : times) states.push_back(y(t));
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const auto& function = problem.switching_functions[k];
    std::vector<TimedValue> values;
    for (std::size_t j = 0; j < times.size(); ++j) {
      const TimedValue now{times[j], function(times[j], states[j])};
      const bool is_on_side = (now.value > 0.0) == sides[k];
      if (!is_on_side && j > 0) return now.t;
      if (is_on_side) values.push_back(now);
    }
    if (values.empty()) continue;
    const ValueAt value = [&](double t) { return function(t, y(t)); };
    resolve(value, values, left);
    if (const auto changes = sign_changes(value, values); !changes.empty()) return changes.front().second.t;
  }
  return std::nullopt;
}

}  // namespace fde
