// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/start_weights/starting_powers.hpp"

#include <algorithm>

#include "fdebench/schemes/problem/smoothness.hpp"
#include "fdebench/schemes/rules/start_weights/start_weights.hpp"

namespace fde {
namespace {

// More powers are never usable: the growth for 24 powers is at least 1e9.
constexpr std::size_t most_powers = 24;

}  // namespace

std::vector<double> StartingPowers::for_steps(int steps) const {
  const auto count = std::min(std::ssize(powers), std::ptrdiff_t{steps} + 1);
  return {powers.begin(), powers.begin() + count};
}

StartingPowers starting_powers(const WeightFamily& family, const Problem& problem) {
  std::vector<double> orders;
  for (const auto& component : problem.components) {
    if (!is_algebraic(component)) orders.push_back(component.order);
  }
  return starting_powers(family, orders, orders);
}

StartingPowers starting_powers(const WeightFamily& family, std::vector<double> orders,
                               std::vector<double> steps) {
  std::ranges::sort(orders);
  orders.erase(std::unique(orders.begin(), orders.end()), orders.end());
  steps.push_back(1.0);
  const double last = family.multistep->rate - 1.0;
  // Multiples of the smallest step that makes another power are as many powers as are needed.
  double smallest = 1.0;
  for (const double step : steps)
    if (step > power_separation) smallest = std::min(smallest, step);
  const double enough = (most_powers + 1.0) * (smallest + 2.0 * power_separation);
  const auto sums = power_lattice({0.0}, steps, std::min(last + 2.0, enough));
  StartingPowers start{{}, 0.0, 0.0};
  for (const double power : sums) {
    if (power <= last + power_separation && start.powers.size() < most_powers) start.powers.push_back(power);
  }
  for (const double order : orders) {
    const auto usable = usable_powers({&family, order}, start.powers);
    start.powers.resize(usable.count);
  }
  for (const double order : orders)
    start.growth = std::max(start.growth, usable_powers({&family, order}, start.powers).growth);
  start.next = sums[start.powers.size()];
  return start;
}

}  // namespace fde
