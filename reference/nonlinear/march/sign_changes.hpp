// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace fde::reference {

// A function of time and its sign, -1, 0 or 1; 0 too where it is not a number.
using TimeFunction = std::function<double(double t)>;
int sign_of(double value);

// Calls `visit` with times in (from, to], increasing, and the values there, until it returns true. Between
// two of these times the function has at most one zero if it is smooth: intervals are halved until a parabola
// describes the function well enough on each, a few thousand times at most, and where the parabola comes near
// 0 without a change of sign the minimum of |function| is looked at.
void walk(const TimeFunction& function, double from, double to,
          const std::function<bool(double t, double value)>& visit);

// The last of the doubles from a to b before the function has the sign of its value at b. Precondition: it
// has another sign at a.
double last_before_change(const TimeFunction& function, double a, double b);

}  // namespace fde::reference
