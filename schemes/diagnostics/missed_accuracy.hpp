// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "fdebench/schemes/problem/resolution.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde {

// Where the error of a run exceeds its tolerance: by so many times rtol |y| + atol.
struct MissedAccuracy {
  double times;
  Eigen::Index row, column;
};

// The values that the same scheme gives for the same problem with another tolerance, in the same rows and
// columns; empty: it does not come to the end.
using OtherRun = std::function<std::optional<Rows>(const Tolerance&)>;

// Compares values of a run with those of a run with ten times its tolerance. If errors are proportional to
// the tolerance, the difference is nine times the error of the run; where that does not decide, or with
// check, a run with a tenth of the tolerance does, whose difference is nine tenths of it. Empty: within five
// times the tolerance, as far as these runs show. Values that are not finite are left out.
std::optional<MissedAccuracy> missed_accuracy(const Tolerance& requested, const Rows& values,
                                              const OtherRun& other, bool check = false);

}  // namespace fde
