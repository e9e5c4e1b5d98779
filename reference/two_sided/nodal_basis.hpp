#pragma once

#include <functional>

#include "problem/problem.hpp"

namespace fde {

// A time in [0, end] as its distances from both ends, each a share of the whole: they sum to 1. Next to an
// end the distance from it keeps its digits.
struct BothShares {
  double from_start, from_end;
  [[nodiscard]] BothShares reversed() const { return {from_end, from_start}; }
};

// Functions on [0, 1] known by their values at nodes, 0 and 1 among them as the first and the last. The nodes
// are symmetric: those in reverse order are the same seen from the end.
struct NodalBasis {
  std::vector<BothShares> nodes;
  // rows(order)(t): the weights of the values at the nodes in 1/Gamma(order) int_0^t (t-s)^(order-1) f(s) ds.
  using Row = std::function<Vec(BothShares t)>;
  std::function<Row(double order)> rows;
};

}  // namespace fde
