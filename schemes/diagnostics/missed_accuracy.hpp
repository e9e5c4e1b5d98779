#pragma once

#include <functional>
#include <optional>

#include "fdebench/schemes/problem/resolution.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde {

// Where a run that was asked for an accuracy is off by more: by so many times relative |y| + absolute.
struct MissedAccuracy {
  double times;
  Eigen::Index row, column;
};

// What the same scheme makes of the same problem where it is asked for another accuracy, in the same rows and
// columns; empty: it does not come to the end.
using OtherRun = std::function<std::optional<Rows>(const Tolerance&)>;

// Compares values of a run with those of one that is asked for ten times less. With errors in proportion to
// what is asked the difference is nine times the error of the run; where that leaves a doubt, or with check,
// a run that is asked for ten times more decides, whose difference is nine tenths of it. Empty: within five
// times what was asked, as far as these tell. Values that are not finite are left out.
std::optional<MissedAccuracy> missed_accuracy(const Tolerance& asked, const Rows& values,
                                              const OtherRun& other, bool check = false);

}  // namespace fde
