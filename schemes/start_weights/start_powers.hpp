#pragma once

#include <vector>

#include "problem/problem.hpp"
#include "weights/family.hpp"

namespace fde {

// The powers t^r of f(t, y(t)) that a multistep rule with start weights integrates exactly: of all sums of
// orders and whole numbers up to rate - 1, beyond which the rule loses nothing at a fixed time, the first so
// many that no row's start weights amplify rounding by more than most_growth. They follow from the orders
// alone.
struct StartPowers {
  std::vector<double> powers;  // the first is 0
  double next;                 // the first of the sums that is not among them
  double growth;               // the largest of all rows

  // Those of a run of so many steps: no more than it has times.
  [[nodiscard]] std::vector<double> of_run(int steps) const;
};
StartPowers start_powers(const WeightFamily& family, const Problem& problem);

// The same for sums of weights of these orders, over samples that start with the sums of these steps.
StartPowers start_powers(const WeightFamily& family, std::vector<double> orders, std::vector<double> steps);

}  // namespace fde
