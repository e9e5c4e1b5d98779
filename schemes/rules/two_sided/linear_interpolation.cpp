// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/two_sided/linear_interpolation.hpp"

namespace fde {

Rows interpolate_linearly(const Grid& from, const Rows& y, const Grid& to) {
  if (from.steps == to.steps) return y;
  Rows result(y.rows(), to.steps + 1);
  int after = 1;
  for (int n = 0; n <= to.steps; ++n) {
    const double t = to.time(n);
    while (after < from.steps && from.time(after) < t) ++after;
    const double before = from.time(after - 1);
    const double share = (t - before) / (from.time(after) - before);
    result.col(n) = (1.0 - share) * y.col(after - 1) + share * y.col(after);
  }
  return result;
}

}  // namespace fde
