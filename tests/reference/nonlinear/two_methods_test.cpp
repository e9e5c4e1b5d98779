// SPDX-License-Identifier: MIT
// The evidence for the reference of a nonlinear scene: two methods with different discretisations agree.

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "fdebench/reference/nonlinear/collocation.hpp"
#include "fdebench/reference/nonlinear/diffusive/diffusive_solution.hpp"
#include "support/testing.hpp"

namespace fde::reference {
namespace {

struct Agreement {
  const char* scene;
  bench::ParameterValues values;
  double end;
  double difference, bound;  // largest allowed, relative to 1 + |y|
};

class TwoMethods : public testing::TestWithParam<Agreement> {};

// With another tolerance and number of stages than in the computation of the bound.
TEST_P(TwoMethods, AgreeToTheStatedSizeAndTheBoundIsNotLarger) {
  const auto& [id, values, end, largest_difference, largest_bound] = GetParam();
  auto scene = bench::scene_of(id, values);
  scene.problem.end = end;
  const Reference reference = reference_solution(scene.problem);
  const std::vector<double> stops{end / 50, end / 10, 0.4 * end};
  const auto second = diffusive_solution(scene.problem, {.stages = 10, .tolerance = 1e-11}, stops);
  int compared = 0;
  for (std::size_t k = 0; k < second.times.size(); ++k) {
    const double t = second.times[k];
    if (t != end && std::ranges::find(stops, t) == stops.end()) continue;
    const ReferenceValue known = reference.at(t);
    for (Eigen::Index i = 0; i < known.value.size(); ++i) {
      const double size = 1 + std::abs(known.value[i]);
      EXPECT_NEAR(known.value[i], second.values[k][i], largest_difference * size) << i << ", t = " << t;
      EXPECT_LT(known.bound[i], largest_bound * size) << i << ", t = " << t;
    }
    ++compared;
  }
  EXPECT_EQ(compared, 4);
}

// For the end 50 the times are t = 1, 5, 20, 50. A pendulum released within 3e-6 of the top is unstable: an
// error in the last digit of its angle grows by a factor of a million before it falls.
INSTANTIATE_TEST_SUITE_P(
    , TwoMethods,
    testing::Values(Agreement{"pendulum", {}, 50, 5e-15, 5e-14},
                    Agreement{"extensible_pendulum", {}, 50, 5e-15, 5e-14},
                    Agreement{"brusselator", {}, 50, 1e-13, 5e-13},
                    Agreement{"pendulum", {{"alpha", 1.9}, {"beta", 0.1}}, 50, 1e-14, 2e-13},
                    Agreement{"pendulum", {{"phi0", 1e-8}, {"dphi0", 0.0}}, 20, 1e-22, 1e-20},
                    Agreement{"pendulum", {{"phi0", 3.14159}, {"dphi0", 0.0}}, 20, 2e-11, 1e-10},
                    Agreement{"extensible_pendulum", {{"phi0", 3.14159}, {"dphi0", 0.0}}, 1.8, 1e-10, 2e-9}),
    [](const auto& test) { return std::string(test.param.scene) + "_" + std::to_string(test.index); });

// The effect of a phase error is largest at the spikes, and the two resolutions of the collocation share it.
TEST(BoundOfAReference, IsSmallOnSpikesWhereTheMethodsDifferMost) {
  auto scene = bench::scene_of("brusselator");
  const Reference reference = reference_solution(scene.problem);
  const auto second = diffusive_solution(scene.problem, {.stages = 10, .tolerance = 1e-11});
  for (std::size_t k = 0; k < second.times.size(); ++k) {
    const ReferenceValue known = reference.at(second.times[k]);
    EXPECT_LT((known.value - second.values[k]).cwiseAbs().maxCoeff(), 1e-11) << second.times[k];
    EXPECT_LT(known.bound.maxCoeff(), 5e-11) << second.times[k];
  }
}

struct Undamped {
  const char* scene;
  bench::ParameterValues values;
};

class Energies : public testing::TestWithParam<Undamped> {};

// The energy E is a constant of the motion, which neither method uses.
TEST_P(Energies, AreKeptByBothMethodsWithoutDamping) {
  auto [id, values] = GetParam();
  for (const auto* damping : {"mu", "lambda", "nu"}) values[damping] = 0.0;
  auto scene = bench::scene_of(id, values);
  scene.problem.end = 50.0;
  const Reference reference = reference_solution(scene.problem);
  const auto second = diffusive_solution(scene.problem);
  const double start = scene.energy.value(reference.at(0.0).value);
  for (int k = 1; k <= 200; ++k) {
    const double t = 0.25 * k;
    EXPECT_NEAR(scene.energy.value(reference.at(t).value), start, 5e-14) << t;
  }
  for (std::size_t k = 0; k < second.times.size(); ++k)
    EXPECT_NEAR(scene.energy.value(second.values[k]), start, 5e-14) << second.times[k];
}

INSTANTIATE_TEST_SUITE_P(
    , Energies,
    testing::Values(Undamped{"pendulum", {}}, Undamped{"pendulum", {{"phi0", 3.0}}},
                    Undamped{"extensible_pendulum", {{"mu1", 0.0}, {"lambda1", 0.0}, {"nu1", 0.0}}}),
    [](const auto& test) { return std::string(test.param.scene) + "_" + std::to_string(test.index); });

// The energy lost equals the work of the damping of orders 3/2 and 1/2. Both sides come from one solution,
// but the power contains derivatives of fractional order, and the energy does not.
class EnergyBalances : public testing::TestWithParam<const char*> {};

TEST_P(EnergyBalances, HoldAlongTheReferenceWithFractionalDamping) {
  using Gauss = boost::math::quadrature::gauss<double, 15>;
  auto scene = bench::scene_of(GetParam());
  scene.problem.end = 20.0;
  const Reference reference = reference_solution(scene.problem);
  const auto power = [&](double t) { return scene.energy.power(t, reference.at(t).value); };
  const double from = 0.5;
  double work = 0.0;
  for (int k = 0; k < 78; ++k) work += Gauss::integrate(power, from + 0.25 * k, from + 0.25 * (k + 1));
  const double gained =
      scene.energy.value(reference.at(20.0).value) - scene.energy.value(reference.at(from).value);
  EXPECT_NEAR(gained, work, 1e-14);
  EXPECT_LT(work, -0.05);
}

INSTANTIATE_TEST_SUITE_P(, EnergyBalances, testing::Values("pendulum", "extensible_pendulum"),
                         bench::text_of_param);

}  // namespace
}  // namespace fde::reference
