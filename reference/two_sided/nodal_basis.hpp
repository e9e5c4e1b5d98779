// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::reference {

// A time in [0, end] as its distances from both ends, relative to end: they sum to 1. Near an end the
// distance from it keeps its relative accuracy.
struct RelativeTime {
  double from_start, from_end;
  [[nodiscard]] RelativeTime reversed() const { return {from_end, from_start}; }
};

// A basis of functions on [0, 1] given by their values at nodes, of which the first is 0 and the last 1. The
// nodes are symmetric under t -> 1 - t.
struct NodalBasis {
  std::vector<RelativeTime> nodes;
  // rows(order)(t): the weights of the values at the nodes in 1/Gamma(order) int_0^t (t-s)^(order-1) f(s) ds.
  using Row = std::function<Vec(RelativeTime t)>;
  std::function<Row(double order)> rows;
};

}  // namespace fde::reference
