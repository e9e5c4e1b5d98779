// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/observers/running_maximum.hpp"

#include <algorithm>
#include <cmath>

#include "fdebench/benchmarks/text/rounded_number.hpp"

namespace fde::bench {
namespace {

constexpr int octaves = 10, digits = 3;
constexpr double between = 1.0 / 8.0;  // of an octave

}  // namespace

RunningMaximum::RunningMaximum(double end) : next_(std::ldexp(end, -octaves)) {}

void RunningMaximum::observe(double t, double value) {
  constexpr double rounding = 1e-12;
  largest_ = std::max(largest_, value);
  if (t < next_ * (1.0 - rounding)) return;
  if (largest_ > 0.0 && std::isfinite(largest_)) add(rounded(t, digits), rounded(largest_, digits));
  while (next_ * (1.0 - rounding) <= t) next_ *= std::exp2(between);
}

// Two times next to each other may be the same to three digits.
void RunningMaximum::add(double t, double value) {
  if (course_.empty() || t > course_.t.back()) {
    course_.t.push_back(t);
    course_.value.push_back(value);
  } else {
    course_.value.back() = value;
  }
}

}  // namespace fde::bench
