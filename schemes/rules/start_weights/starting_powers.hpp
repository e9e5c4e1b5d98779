// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/history/weights/family.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// The powers t^r of f(t, y(t)) that a multistep rule with starting weights integrates exactly. The candidates
// are all sums of orders and integers up to rate - 1 (larger powers do not reduce the rate at a fixed time);
// the first ones are used, as many as keep the rounding amplification of every row's starting weights below
// max_growth. They depend on the orders only.
struct StartingPowers {
  std::vector<double> powers;  // the first is 0
  double next;                 // the smallest candidate, of any size, that is not used
  double growth;               // rounding amplification, the maximum over all rows

  // The powers for a run with this number of steps: at most steps + 1.
  [[nodiscard]] std::vector<double> for_steps(int steps) const;
};
StartingPowers starting_powers(const WeightFamily& family, const Problem& problem);

// The same for memory sums with weights of these orders, over samples whose powers are sums of `steps` and
// integers.
StartingPowers starting_powers(const WeightFamily& family, std::vector<double> orders,
                               std::vector<double> steps);

}  // namespace fde
