// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/march/sign_changes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace fde::reference {
namespace {

struct Sample {
  double t, value;
};

// Places on an interval, not equally spaced, as the function may be periodic.
constexpr std::array places{0.0, 0.2361, 0.5278, 0.7639, 1.0};
using Samples = std::array<Sample, places.size()>;

// The parabola through the first, the middle and the last sample, at the place x.
double parabola(const Samples& samples, double x) {
  const double middle = places[2];
  const auto& [a, b, c, d, e] = samples;
  return a.value * (x - middle) * (x - 1.0) / middle - c.value * x * (x - 1.0) / (middle * (1.0 - middle)) +
         e.value * x * (x - middle) / (1.0 - middle);
}

double least_size(const Samples& samples) {
  double least = std::abs(samples.front().value);
  for (const auto& [t, value] : samples) least = std::min(least, std::abs(value));
  return least;
}

// Whether the parabola is off by more than a tenth of the range of the values, so that a zero may be missed.
bool is_unresolved(const Samples& samples) {
  constexpr double smooth = 0.1, may_hide = 0.25;
  const auto [low, high] = std::ranges::minmax(samples, {}, &Sample::value);
  const double off = std::max(std::abs(parabola(samples, places[1]) - samples[1].value),
                              std::abs(parabola(samples, places[3]) - samples[3].value));
  return off > smooth * (high.value - low.value) && off > may_hide * least_size(samples);
}

// A minimum of a function between a and b, to half of the digits.
double minimum(const TimeFunction& function, double a, double b) {
  constexpr double golden = 0.3819660112501051;
  constexpr int reductions = 40;
  double left = a + golden * (b - a), right = b - golden * (b - a);
  double at_left = function(left), at_right = function(right);
  for (int k = 0; k < reductions; ++k) {
    if (at_left < at_right) {
      b = std::exchange(right, left);
      at_right = at_left;
      left = a + golden * (b - a);
      at_left = function(left);
    } else {
      a = std::exchange(left, right);
      at_left = at_right;
      right = b - golden * (b - a);
      at_right = function(right);
    }
  }
  return at_left < at_right ? left : right;
}

class Walk {
 public:
  Walk(const TimeFunction& function, const std::function<bool(double, double)>& visit)
      : function_(function), visit_(visit) {}

  // Whether it has been stopped. The first sample has been visited. The samples of an oscillation may be on a
  // parabola by chance: those of its halves must be on parabolas too.
  bool along(const Sample& first, const Sample& last, int halvings_left, bool is_half_of_resolved) {
    Samples samples{first, {}, {}, {}, last};
    for (std::size_t k = 1; k + 1 < samples.size(); ++k) {
      const double t = first.t + places[k] * (last.t - first.t);
      samples[k] = {t, function_(t)};
    }
    const bool resolved = !is_unresolved(samples);
    if (halvings_left > 0 && most_ > 0 && !(resolved && is_half_of_resolved)) {
      --most_;
      return along(first, samples[2], halvings_left - 1, resolved) ||
             along(samples[2], last, halvings_left - 1, resolved);
    }
    auto dip = dip_of(samples);
    for (std::size_t k = 1; k < samples.size(); ++k) {
      if (dip && dip->t < samples[k].t && visit(std::exchange(dip, {}))) return true;
      if (samples[k].t > samples[k - 1].t && visit_(samples[k].t, samples[k].value)) return true;
    }
    return false;
  }

 private:
  bool visit(const std::optional<Sample>& sample) { return visit_(sample->t, sample->value); }

  // Where all samples have the same sign and the function has another one between them.
  [[nodiscard]] std::optional<Sample> dip_of(const Samples& samples) const {
    const int sign = sign_of(samples.front().value);
    const bool all =
        sign != 0 && std::ranges::all_of(
                         samples, [&](double value) { return sign_of(value) == sign; }, &Sample::value);
    if (!all) return std::nullopt;
    constexpr int looked_at = 64;
    double least = least_size(samples);
    const double near = least / 2.0;
    for (int k = 0; k <= looked_at; ++k)
      least = std::min(least, sign * parabola(samples, static_cast<double>(k) / looked_at));
    if (least > near) return std::nullopt;
    const double t =
        minimum([&](double at) { return sign * function_(at); }, samples.front().t, samples.back().t);
    const Sample dip{t, function_(t)};
    return sign_of(dip.value) == -sign ? std::optional(dip) : std::nullopt;
  }

  const TimeFunction& function_;
  const std::function<bool(double, double)>& visit_;
  int most_ = 4096;
};

}  // namespace

int sign_of(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

void walk(const TimeFunction& function, double from, double to,
          const std::function<bool(double t, double value)>& visit) {
  constexpr int pieces = 6, most_halvings = 24;
  constexpr double golden = 0.6180339887498949, aside = 0.3;
  Walk of(function, visit);
  Sample before{from, function(from)};
  for (int piece = 1; piece <= pieces; ++piece) {
    const double multiple = golden * piece, off = aside * (multiple - std::floor(multiple) - 0.5);
    const double t = piece == pieces ? to : from + (to - from) * (piece + off) / pieces;
    if (!(t > before.t)) continue;
    const Sample next{t, function(t)};
    if (of.along(before, next, most_halvings, false)) return;
    before = next;
  }
}

double last_before_change(const TimeFunction& function, double a, double b) {
  const int sign = sign_of(function(b));
  for (;;) {
    const double middle = a + (b - a) / 2.0;
    if (middle <= a || middle >= b) return a;
    (sign_of(function(middle)) == sign ? b : a) = middle;
  }
}

}  // namespace fde::reference
