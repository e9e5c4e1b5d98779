// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/formulations/motion_powers.hpp"

#include <algorithm>
#include <utility>

namespace fde::bench::mechanics {
namespace {

constexpr double last = 3.0;  // higher powers do not change the rate

std::vector<double> shifted(std::vector<double> powers, double by) {
  for (double& power : powers) power += by;
  return powers;
}

std::vector<double> without(std::vector<double> powers, double power) {
  std::erase_if(powers, [=](double p) { return same_order(p, power); });
  return powers;
}

std::vector<double> with_zero(std::vector<double> powers) {
  powers.insert(powers.begin(), 0.0);
  return powers;
}

// Assigns the powers of each group to its rows.
Smoothness smoothness_of_groups(const Layout& layout,
                                const std::vector<std::pair<RowBlock, std::vector<double>>>& groups) {
  Smoothness smoothness;
  smoothness.powers.resize(static_cast<std::size_t>(layout.size()));
  for (const auto& [rows, powers] : groups) {
    for (int i = 0; i < rows.size; ++i) smoothness.powers[rows[i]] = powers;
  }
  return smoothness;
}

}  // namespace

MotionExponents powers_below_one(double order, bool moving, ReactionStart reaction) {
  const std::vector<double> steps{1.0, 1.0 - order};
  const bool regular = reaction == ReactionStart::regular;
  const auto leaving = power_lattice(regular ? std::vector{1.0} : std::vector{1.0 - order, 1.0}, steps, last);
  const auto all = with_zero(leaving);
  return {moving ? all : leaving, reaction == ReactionStart::singular_with_varying_direction
                                      ? power_lattice({2.0 - 2.0 * order, 1.0}, steps, last)
                                      : shifted(all, 1.0)};
}

// a.v - a.v(0) depends on z and on itself: A = (b.z - b.v)/(b.a^#), b.v - b.v(0) = -J^(order-1) A.
MotionExponents powers_above_one(double order, bool moving) {
  const auto leaving = power_lattice({1.0}, {1.0, order - 1.0}, last);
  const auto all = with_zero(leaving);
  return {moving ? all : leaving, shifted(all, 1.0)};
}

Smoothness integrated_start(const MotionExponents& powers, double order, const Layout& layout) {
  return smoothness_of_groups(layout, {{layout.q, shifted(powers.velocity, 1.0)},
                                       {layout.z, powers.free_part},
                                       {layout.w, shifted(powers.velocity, 1.0 - order)}});
}

Smoothness acceleration_start(const MotionExponents& powers, double order, const Layout& layout,
                              bool singular) {
  const auto leaving = without(powers.velocity, 0.0);
  return smoothness_of_groups(
      layout, {{layout.q, shifted(powers.velocity, 1.0)},
               {layout.v, leaving},
               {layout.s, shifted(singular ? without(leaving, 1.0 - order) : leaving, -order)},
               {layout.w, shifted(powers.velocity, 1.0 - order)}});
}

// D^(2-order) W = z'.
Smoothness integrated_start_above_one(const MotionExponents& powers, double order, const Layout& layout) {
  return smoothness_of_groups(layout, {{layout.q, shifted(powers.velocity, 1.0)},
                                       {layout.z, powers.free_part},
                                       {layout.chi, shifted(without(powers.velocity, 0.0), order - 1.0)},
                                       {layout.w, shifted(powers.free_part, 1.0 - order)}});
}

}  // namespace fde::bench::mechanics
