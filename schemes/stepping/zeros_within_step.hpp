// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// A function along a step, and its value at one time.
using ValueAt = std::function<double(double t)>;
struct TimedValue {
  double t, value;
};

// The most values of a run that resolve() may add.
constexpr std::uint64_t most_samples = 1'000'000;

// Adds values until parabolas through them describe the function, by halving the intervals between them.
// Noise is never described: for it the number of values is bounded per step and, by `left`, per run.
void resolve(const ValueAt& value, std::vector<TimedValue>& samples, std::uint64_t& left);

// Pairs of values between which the function changes its sign, by increasing time. Two zeros in one interval
// are found through the minimum of |value| there.
std::vector<std::pair<TimedValue, TimedValue>> sign_changes(const ValueAt& value,
                                                            const std::vector<TimedValue>& samples);

// A time of a step at which a function of problem.switching_functions has another sign than in `sides`
// (switch_signs()): one of `times`, which are in the step and increase, or one between two zeros that lie
// between these. At the first of the times, where y may have rounding errors of a switch, the sign does not
// matter. nullopt: there is none. y: along the step; left: as for resolve().
std::optional<double> time_on_other_side(const Problem& problem, const std::vector<bool>& sides,
                                         const std::vector<double>& times,
                                         const std::function<Vec(double t)>& y, std::uint64_t& left);

}  // namespace fde
