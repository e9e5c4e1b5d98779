// A reference of a nonlinear scene is believed because two methods that share nothing agree on it.

#include <gtest/gtest.h>

#include "collocation.hpp"
#include "diffusive_march.hpp"
#include "testing.hpp"

namespace fde {
namespace {

struct Agreement {
  const char* scene;
  std::map<std::string, double> values;
  double end;
  double bound;  // at most, relative to 1 + |y|
};

class TwoMethods : public testing::TestWithParam<Agreement> {};

TEST_P(TwoMethods, AgreeWithinTheStatedBound) {
  const auto& [id, values, end, largest_bound] = GetParam();
  auto scene = scene_of(id, values);
  scene.problem.end = end;
  const Exact reference = reference_solution(scene.problem);
  // Other steps than those that the bound is made from.
  const auto second =
      diffusive_solution(scene.problem, {.stages = 10, .tolerance = 1e-11}, {end / 50, end / 10, 0.4 * end});
  int compared = 0;
  for (std::size_t k = 0; k < second.times.size(); ++k) {
    const double t = second.times[k];
    if (t != end / 50 && t != end / 10 && t != 0.4 * end && t != end) continue;
    const Truth truth = reference.at(t);
    const Vec difference = (truth.value - second.values[k]).cwiseAbs();
    for (Eigen::Index i = 0; i < difference.size(); ++i) {
      EXPECT_LE(difference[i], truth.bound[i]) << "component " << i << ", t = " << t;
      EXPECT_LT(truth.bound[i], largest_bound * (1 + std::abs(truth.value[i])))
          << "component " << i << ", t = " << t;
    }
    ++compared;
  }
  EXPECT_EQ(compared, 4);
}

// To T = 50 these are t = 1, 5, 20, 50. A pendulum released within 3e-6 of the top is unstable: the last
// digit of its angle grows a million times before it falls.
INSTANTIATE_TEST_SUITE_P(
    , TwoMethods,
    testing::Values(Agreement{"pendulum", {}, 50, 5e-14}, Agreement{"extensible_pendulum", {}, 50, 5e-14},
                    Agreement{"brusselator", {}, 50, 5e-13},
                    Agreement{"pendulum", {{"alpha", 1.9}, {"beta", 0.1}}, 50, 2e-13},
                    Agreement{"pendulum", {{"phi0", 1e-8}, {"dphi0", 0.0}}, 20, 1e-20},
                    Agreement{"pendulum", {{"phi0", 3.14159}, {"dphi0", 0.0}}, 20, 1e-10},
                    Agreement{"extensible_pendulum", {{"phi0", 3.14159}, {"dphi0", 0.0}}, 10, 2e-9}),
    [](const auto& test) { return std::string(test.param.scene) + "_" + std::to_string(test.index); });

// What a bound that knows one method only would miss: at the spikes, where an error of time is largest.
TEST(BoundOfAReference, CoversTheDifferenceOfTheMethodsAtEveryStep) {
  auto scene = scene_of("brusselator");
  const Exact reference = reference_solution(scene.problem);
  const auto second = diffusive_solution(scene.problem);
  for (std::size_t k = 0; k < second.times.size(); ++k) {
    if (second.times[k] < 1e-9) continue;
    const Truth truth = reference.at(second.times[k]);
    EXPECT_TRUE(((truth.value - second.values[k]).cwiseAbs().array() <= truth.bound.array()).all());
    EXPECT_LT(truth.bound.maxCoeff(), 5e-11);
  }
}

}  // namespace
}  // namespace fde
