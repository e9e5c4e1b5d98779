// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/reference/reference.hpp"
#include "fdebench/reference/special_functions/numbers/bounded.hpp"

namespace fde::reference {

// Real columns as functions of time, in long double and in multiprecision, for as_reference().
struct Evaluation {
  std::string name;  // prefix of the error messages
  // Evaluation in long double, rounded to double; nullopt where it is not accurate enough. Optional.
  std::function<std::optional<std::vector<BoundedDouble>>(double t)> quick{};
  // Each column to a relative accuracy of `digits` decimal digits. Precondition: a Precision is in force.
  std::function<std::vector<Bounded<BigReal>>(double t, int digits)> precise;
  double end = std::numeric_limits<double>::infinity();  // times are finite and in [0, end]
};

// The columns at time t: those of `quick`, or else of `precise` with double_digits digits, rounded to double.
std::vector<BoundedDouble> evaluate_in_double(const Evaluation& evaluation, double t);

// Both functions of the reference throw std::invalid_argument if t is not finite or outside [0, end], and
// digits(t, digits) also if digits < 1.
Reference as_reference(const Evaluation& evaluation);

}  // namespace fde::reference
