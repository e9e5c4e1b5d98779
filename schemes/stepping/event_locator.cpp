// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/event_locator.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <utility>

#include "fdebench/schemes/stepping/zeros_within_step.hpp"

namespace fde {
namespace {

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

// The zero between two times at which the values have different signs: of the two adjacent doubles that
// enclose it the one with the smaller |value|.
double zero_between(const ValueAt& value, const TimedValue& before, const TimedValue& behind) {
  std::uintmax_t evaluations = 200;
  const auto neighbours = [](double a, double b) { return std::nextafter(a, b) >= b; };
  const auto [low, high] = boost::math::tools::toms748_solve(value, before.t, behind.t, before.value,
                                                             behind.value, neighbours, evaluations);
  return low > before.t && std::abs(value(low)) < std::abs(value(high)) ? low : high;
}

// Adds samples at those of the times that lie between the samples.
void add_times(const std::vector<double>& times, const ValueAt& value, std::vector<TimedValue>& samples) {
  const double end = samples.back().t;
  for (auto t = std::ranges::upper_bound(times, samples.front().t); t != times.end() && *t < end; ++t)
    samples.insert(std::ranges::upper_bound(samples, *t, {}, &TimedValue::t), {*t, value(*t)});
}

bool counts(Crossing crossing, const TimedValue& before) {
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
    const ValueAt value = [&](double at) { return events_[e].value(at, at == t ? Vec(y) : within.at(at)); };
    if (const auto& jump = events_[e].last_jump; jump && jump() >= time_) values_[e] = value(time_);
    std::vector<TimedValue> samples{{time_, values_[e]}};
    for (std::size_t k = 1; k < times.size(); ++k)
      samples.push_back({times[k], events_[e].value(times[k], states[k])});
    add_times(events_[e].times, value, samples);
    resolve(value, samples, left_);
    for (const auto& [before, behind] : sign_changes(value, samples)) {
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
