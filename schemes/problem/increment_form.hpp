// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// The right-hand side of a problem and its Jacobian as functions of z = y - origin, where origin_i is y_i(0),
// and 0 in an algebraic row. Where f contains differences y_i - y_i(0), it has their relative accuracy, which
// y loses next to t = 0 by rounding.
struct IncrementForm {
  Vec origin{};  // empty: the problem has no such form
  std::function<void(double t, In z, Out f)> rhs{};
  std::function<void(double t, In z, OutMatrix jacobian)> jacobian{};

  [[nodiscard]] bool is_given() const { return origin.size() > 0; }
};

}  // namespace fde
