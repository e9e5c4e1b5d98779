// SPDX-License-Identifier: MIT
// Pendulums over 15000 swings, T = 1e5.

#include <gtest/gtest.h>

#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

constexpr double end = 1e5;
constexpr int steps = 1 << 20;

Scene pendulum(const ParameterValues& values) {
  return make_scene({.factory = find_scene("pendulum"), .values = values, .until = end});
}

struct Energies {
  SolveStatus ending = SolveStatus::finished;
  double first = 0.0, largest = 0.0, last = 0.0;
};

// Energies at every 16th step, above the energy of the pendulum at rest.
Energies energies(const Scene& scene, std::string_view scheme) {
  const Scene rest = pendulum({{"phi0", 0.0}, {"dphi0", 0.0}});
  const double lowest = rest.energy.value(columns_at(rest.outputs, 0.0, taylor_part(rest.problem, 0.0)));
  Energies seen;
  Options options{.output_times = {end}};
  options.observer = [&, n = 0](double t, In y) mutable {
    if (n++ % 16 != 0) return;
    seen.last = scene.energy.value(columns_at(scene.outputs, t, y)) - lowest;
    if (t == 0.0) seen.first = seen.last;
    seen.largest = std::max(seen.largest, seen.last);
  };
  seen.ending = solve(scheme, scene.problem, Grid{end, steps}, options).status;
  return seen;
}

class DampedForLong : public testing::TestWithParam<std::string_view> {};

// Damping dissipates energy: no scheme may add any. The remainder is the tail of the memory term, which falls
// like a power of t.
TEST_P(DampedForLong, KeepsItsEnergyBounded) {
  const auto seen = energies(pendulum({}), GetParam());
  EXPECT_EQ(seen.ending, SolveStatus::finished);
  EXPECT_LE(seen.largest, seen.first);
  EXPECT_LT(seen.last, 1e-7 * seen.first);
}

INSTANTIATE_TEST_SUITE_P(, DampedForLong,
                         testing::Values("adams_pc", "l1", "grunwald_letnikov", "product_trapezoidal",
                                         "decoupled_multi_order"),
                         text_of_param);

const ParameterValues undamped{{"mu", 0.0}, {"nu", 0.0}, {"lambda", 0.0}};

// At order 1 the product trapezoidal rule is the trapezoidal rule, which conserves a modified energy, O(h^2)
// from that of the pendulum: the energy does not drift, while the phase does.
TEST(UndampedForLong, TheTrapezoidalRuleKeepsTheEnergy) {
  const auto seen = energies(pendulum(undamped), "product_trapezoidal");
  EXPECT_EQ(seen.ending, SolveStatus::finished);
  EXPECT_LT(seen.largest, 1.01 * seen.first);
  EXPECT_GT(seen.last, 0.99 * seen.first);
}

// Backward Euler dissipates energy, Heun's method adds energy.
TEST(UndampedForLong, OthersDoNot) {
  const auto euler = energies(pendulum(undamped), "grunwald_letnikov");
  EXPECT_EQ(euler.ending, SolveStatus::finished);
  EXPECT_LT(euler.last, 1e-9);
  const auto heun = energies(pendulum(undamped), "adams_pc");
  EXPECT_GT(heun.largest, 1.1 * heun.first);
}

}  // namespace
}  // namespace fde::bench
