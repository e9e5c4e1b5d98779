// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::reference {

Vec rhs_at(const Problem& problem, double t, In y);

// y and the returned f have one row per time.
Matrix rhs_at(const Problem& problem, const Vec& times, const Matrix& y);

// The largest change of each f_i when the times are moved by their last digit towards `from`: a rounding
// error of f that a steep load has.
Vec rounding_of_times(const Problem& problem, double from, const Vec& times, const Matrix& y,
                      const Matrix& rhs);

// The largest |f_i| at the initial values over [0, end], where step limits show that it changes quickly and
// elsewhere: rounding errors of f have this size also where f is small, as 1 - cos t near 0 and a pulse
// before it begins.
Vec largest_forcing(const Problem& problem);

}  // namespace fde::reference
