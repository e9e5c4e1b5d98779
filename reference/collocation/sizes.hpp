#pragma once

#include <vector>

#include "problem/problem.hpp"

namespace fde {

// What rounding, and so every tolerance, is relative to. Each is the largest so far, a number a component.
struct Sizes {
  Vec values;   // of y_i
  Vec rhs;      // of the terms that f_i is made of
  Vec forcing;  // of f_i at the initial values, at all times: a forcing like 1 - cos t is all rounding near 0
  Vec noise;    // rounding that no size tells of: that of terms of f_i which cancel for every y

  [[nodiscard]] double largest() const { return values.cwiseMax(rhs).maxCoeff(); }
};

// Without what algebraic rows make of it: their unknowns may start unbounded, and so may what these drive. Of
// no measure for what comes later, where the problem has such rows, are f so far and these unknowns.
Sizes bounded_sizes(Sizes sizes, const Problem& problem);

Sizes sizes_at_start(const Problem& problem);

// With y and f at the nodes of a panel, a row a node, and df/dy there.
Sizes sizes_with(const Sizes& before, const Matrix& y, const Matrix& rhs,
                 const std::vector<Matrix>& jacobians);

}  // namespace fde
