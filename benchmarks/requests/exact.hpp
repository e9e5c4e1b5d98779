// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/requests/failure.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// What is known of a scene at some times, whatever solves it. The names are those of the columns, then of
// energies and constraints, then of multipliers, where these are known exactly.
struct ExactTable {
  std::vector<std::string> names{};
  Rows values{};  // one row a name, one column a time
  // Of the absolute error, or an estimate of it: one row a column of the scene and a singular value.
  Rows bounds{};
};

// Called with each time before the reference is evaluated there, and first with the last time for which the
// reference is computed.
using BeforeTime = std::function<void(double t)>;

// The reference of the scene at these times, in any order, also beyond its end where it is no problem at both
// ends. Throws Refusal for a time that is not in [0, infinity), or not in the interval of a problem at
// both ends; std::runtime_error where there is no reference; and NumericalFailure, which is one, where a
// value or a bound is beyond double.
ExactTable exact(Scene scene, const std::vector<double>& times, const BeforeTime& before = {});

// For each time the columns as decimals, each with its bound. The energies and constraints of exact() are
// computed in double only, so they are left out. `id` names the scene in messages. Throws Refusal, also
// for a scene that has no such decimals, and NumericalFailure, as exact() does.
std::vector<std::vector<reference::Decimal>> exact_in_digits(const Scene& scene, std::string_view id,
                                                             const std::vector<double>& times, int digits,
                                                             const BeforeTime& before = {});

}  // namespace fde::bench
