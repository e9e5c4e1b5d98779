// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/event_locator.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <utility>

namespace fde {
namespace {

struct Sample {
  double t, value;
};
using Value = std::function<double(double t)>;

// The initial sample times on a step from `start` to `end`. Samples next to the ends give the sign of the
// slope of |value| there. The others are not equally spaced, to avoid aliasing with a periodic function.
std::vector<double> looked_at(double start, double end, int pieces) {
  constexpr double next_to = 1e-3;                            // of the step
  constexpr double aside = 0.3, golden = 0.6180339887498949;  // of a piece; multiples are equidistributed
  std::vector<double> times{start};
  const auto add = [&](double share) {
    const double t = start + share * (end - start);
    if (t > times.back() && t < end) times.push_back(t);
  };
  add(next_to);
  for (int piece = 1; piece < pieces; ++piece) {
    const double multiple = golden * piece;
    add((piece + aside * (multiple - std::floor(multiple) - 0.5)) / pieces);
  }
  add(1.0 - next_to);
  times.push_back(end);
  return times;
}

// The distance of a sample from the parabola through three others.
double off_parabola(const Sample& sample, const Sample& a, const Sample& b, const Sample& c) {
  const auto part = [&](const Sample& of, const Sample& one, const Sample& other) {
    return of.value * ((sample.t - one.t) / (of.t - one.t)) * ((sample.t - other.t) / (of.t - other.t));
  };
  return std::abs(part(a, b, c) + part(b, a, c) + part(c, a, b) - sample.value);
}

// For each sample whether the interval to its left must be halved. The intervals around a sample are halved
// where its distance from the parabola through three neighbours is more than 1/10 of the range of the values
// and more than 1/4 of the nearest |value|, so that a zero may be missed. If this holds for more than a
// quarter of the intervals, all are halved: the others may look smooth by chance.
std::vector<bool> unresolved(const std::vector<Sample>& samples) {
  constexpr double smooth = 0.1, may_hide = 0.25;
  constexpr std::size_t many = 4;  // 1/4 of the intervals
  std::vector<bool> halve(samples.size(), false);
  if (samples.size() < 4) return halve;
  for (std::size_t k = 1; k + 1 < samples.size(); ++k) {
    const std::size_t first = std::min(k < 2 ? 0 : k - 2, samples.size() - 4), last = first + 3;
    std::vector<Sample> others(samples.begin() + static_cast<std::ptrdiff_t>(first),
                               samples.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    const auto [low, high] = std::ranges::minmax(others, {}, &Sample::value);
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

std::vector<Sample> halved(const Value& value, const std::vector<Sample>& samples,
                           const std::vector<bool>& halve) {
  std::vector<Sample> more;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (halve[k]) {
      const double t = samples[k - 1].t + (samples[k].t - samples[k - 1].t) / 2.0;
      if (t > samples[k - 1].t && t < samples[k].t) more.push_back({t, value(t)});
    }
    more.push_back(samples[k]);
  }
  return more;
}

// Adds samples until parabolas through them resolve the function. Noise is never resolved; for it the number
// of samples is bounded per step and, by `left`, per run.
void resolve(const Value& value, std::vector<Sample>& samples, std::uint64_t& left) {
  constexpr int most_halvings = 24;
  constexpr std::uint64_t most_samples = 20000;
  for (int round = 0; round < most_halvings && samples.size() < std::min(most_samples, left); ++round) {
    auto more = halved(value, samples, unresolved(samples));
    if (more.size() == samples.size()) return;
    left -= std::min<std::uint64_t>(left, more.size() - samples.size());
    samples = std::move(more);
  }
}

// The zero between two times at which the values have different signs: of the two adjacent doubles that
// enclose it the one with the smaller |value|.
double zero_between(const Value& value, const Sample& before, const Sample& behind) {
  std::uintmax_t evaluations = 200;
  const auto neighbours = [](double a, double b) { return std::nextafter(a, b) >= b; };
  const auto [low, high] = boost::math::tools::toms748_solve(value, before.t, behind.t, before.value,
                                                             behind.value, neighbours, evaluations);
  return low > before.t && std::abs(value(low)) < std::abs(value(high)) ? low : high;
}

// A sample at the minimum of |value| between two samples of equal sign that enclose it. If the function has
// two zeros there, the sample has the opposite sign.
Sample beyond(const Value& value, const Sample& before, const Sample& behind) {
  constexpr int bits = 26;  // a minimum is determined to half of the digits only
  std::uintmax_t evaluations = 100;
  const double sign = std::copysign(1.0, before.value);
  const auto [at, least] = boost::math::tools::brent_find_minima([&](double t) { return sign * value(t); },
                                                                 before.t, behind.t, bits, evaluations);
  return {at, sign * least};
}

bool opposite(const Sample& one, const Sample& other) { return one.value * other.value < 0.0; }

// Pairs of samples between which the value changes its sign.
std::vector<std::pair<Sample, Sample>> changes(const Value& value, const std::vector<Sample>& samples) {
  std::vector<std::pair<Sample, Sample>> found;
  Sample sided = samples.front();  // the last sample that is finite and not 0
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const Sample& now = samples[k];
    if (opposite(sided, now)) found.emplace_back(sided, now);
    if (now.value != 0.0 && std::isfinite(now.value)) sided = now;
    if (k + 1 == samples.size()) break;
    const Sample &before = samples[k - 1], &behind = samples[k + 1];
    const auto size = [](const Sample& sample) { return std::abs(sample.value); };
    const bool one_side = before.value * now.value > 0.0 && now.value * behind.value > 0.0;
    if (!one_side || !(size(now) < size(before)) || !(size(now) <= size(behind))) continue;
    const Sample there = beyond(value, before, behind);
    if (!opposite(now, there)) continue;
    found.emplace_back(before, there);
    found.emplace_back(there, behind);
  }
  return found;
}

bool counts(Crossing crossing, const Sample& before) {
  return crossing == Crossing::either || (crossing == Crossing::rising) == (before.value < 0.0);
}

}  // namespace

void EventOccurrence::state(Archive& archive) {
  archive(event, t);
  archive.resizable(y);
}

EventLocator::EventLocator(const std::vector<Event>& events, In start) : events_(events) {
  for (const auto& event : events_) values_.push_back(event.value(0.0, start));
}

std::vector<EventOccurrence> EventLocator::step(double t, In y, const StepInterpolant& within) {
  const auto times = looked_at(time_, t, within.pieces);
  std::vector<Vec> states;
  for (const double at : times) states.push_back(at == time_ || at == t ? Vec(y) : within.at(at));
  std::vector<EventOccurrence> found;
  for (std::size_t e = 0; e < events_.size(); ++e) {
    const Value value = [&](double at) { return events_[e].value(at, at == t ? Vec(y) : within.at(at)); };
    if (const auto& jump = events_[e].last_jump; jump && jump() >= time_) values_[e] = value(time_);
    std::vector<Sample> samples{{time_, values_[e]}};
    for (std::size_t k = 1; k < times.size(); ++k)
      samples.push_back({times[k], events_[e].value(times[k], states[k])});
    resolve(value, samples, left_);
    for (const auto& [before, behind] : changes(value, samples)) {
      if (counts(events_[e].crossing, before)) found.push_back({e, zero_between(value, before, behind), {}});
    }
    // At a zero the sign of the previous sample is kept.
    if (samples.back().value != 0.0) values_[e] = samples.back().value;
  }
  std::ranges::stable_sort(found, {}, &EventOccurrence::t);
  const auto last =
      std::ranges::find_if(found, [&](const EventOccurrence& one) { return events_[one.event].terminal; });
  if (last != found.end()) found.erase(last + 1, found.end());
  for (auto& one : found) one.y = one.t == t ? Vec(y) : within.at(one.t);
  time_ = t;
  return found;
}

}  // namespace fde
