// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "fdebench/schemes/history/weights/family.hpp"

namespace fde {

// Completes a family whose weights are integrals of t^(-g), g <= 1, and apply to increments of y.
constexpr WeightFamily increment_family(WeightFamily row) {
  using Real = long double;
  row.acts_on_increments = true;
  row.first_sample_weight = [](Real /*g*/, Real /*n*/) -> Real { return 0; };
  row.weight_at_order_one = 0.0;
  row.step_factor = [](Real g) { return std::tgamma(2 - g); };
  return row;
}

}  // namespace fde
