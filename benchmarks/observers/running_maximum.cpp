// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/observers/running_maximum.hpp"

#include <algorithm>
#include <cmath>

#include "fdebench/benchmarks/text/rounded_number.hpp"

namespace fde::bench {
namespace {

constexpr int octaves = 10, digits = 3;
constexpr double between = 1.0 / 8.0;  // of an octave
constexpr double rounding = 1e-12;

}  // namespace

RunningMaximum::RunningMaximum(double end) : next_(std::ldexp(end, -octaves)) {}

void RunningMaximum::observe(double t, double value) {
  largest_ = std::max(largest_, value);
  if (t < next_ * (1.0 - rounding)) return;
  if (largest_ > 0.0 && std::isfinite(largest_)) add(rounded(t, digits), rounded(largest_, digits));
  while (next_ * (1.0 - rounding) <= t) next_ *= std::exp2(between);
}

// Two times next to each other may be the same to three digits. Of equal values the first and the last are
// kept, which suffice to draw them.
void RunningMaximum::add(double t, double value) {
  auto& [times, values] = course_;
  const auto count = values.size();
  const bool is_level = count > 1 && values[count - 1] == value && values[count - 2] == value;
  if (count > 0 && (is_level || t <= times.back())) {
    times.back() = std::max(times.back(), t);
    values.back() = value;
  } else {
    times.push_back(t);
    values.push_back(value);
  }
}

}  // namespace fde::bench
