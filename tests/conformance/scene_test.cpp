// SPDX-License-Identifier: MIT
// Properties of every scene in the list, and of single ones.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

class EveryScene : public testing::TestWithParam<const SceneFactory*> {
 protected:
  const Scene scene_ = make_scene(*GetParam());

  // Points near the initial values, of which unknown ones are 1.
  [[nodiscard]] std::vector<Vec> points() const {
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> uniform(-0.4, 0.4);
    std::vector<Vec> result;
    for (int i = 0; i < 5; ++i) {
      result.emplace_back(taylor_part(with_some_initial_values(scene_.problem), 0.0) +
                          Vec::NullaryExpr(scene_.problem.size(), [&] { return uniform(generator); }));
    }
    return result;
  }

  [[nodiscard]] Vec rhs(double t, In y) const {
    Vec f(y.size());
    scene_.problem.rhs(t, y, f);
    return f;
  }
};

TEST_P(EveryScene, FitsEverySchemeOrIsRefusedWithAReason) {
  for (const auto& scheme : schemes()) {
    const auto reason = unsupported_reason(scheme, scene_.problem, Grid{scene_.problem.end, 16});
    if (reason) {
      EXPECT_GT(reason->size(), 10U);
    } else if (const auto rate =
                   theoretical_rate(scheme, scene_.problem, scene_.smoothness, 1.0, Norm::end)) {
      EXPECT_GT(*rate, 0.0) << scheme.id;
    }
  }
}

TEST_P(EveryScene, SaysItsEquations) {
  const SceneFactory& factory = *GetParam();
  EXPECT_FALSE(factory.equations.empty() && factory.display_equations.empty());
}

TEST_P(EveryScene, HasConsistentShapes) {
  const auto size = static_cast<std::size_t>(scene_.problem.size());
  if (!scene_.smoothness.powers.empty()) {
    EXPECT_EQ(scene_.smoothness.powers.size(), size);
  }
  if (!scene_.outputs.evaluate) {
    EXPECT_EQ(scene_.outputs.names.size(), size);
  }
  for (const auto& component : scene_.problem.components) {
    const auto count = initial_count(component.order);
    if (scene_.problem.conditions) {
      EXPECT_LE(component.initial.size(), count);
    } else {
      EXPECT_EQ(component.initial.size(), count);
    }
  }
}

TEST_P(EveryScene, HasTheDerivativesOfItsRightHandSide) {
  const auto& problem = scene_.problem;
  if (!has_jacobian(problem)) GTEST_SKIP();
  for (const Vec& y : points()) {
    Matrix declared(y.size(), y.size());
    evaluate_jacobian(problem, 0.3, y, declared);
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      Vec above = y, below = y;
      above[i] += 1e-5;
      below[i] -= 1e-5;
      const Vec differenced = (rhs(0.3, above) - rhs(0.3, below)) / (above[i] - below[i]);
      const double size = std::max(1.0, differenced.cwiseAbs().maxCoeff());
      const double rounding = 1e-10 * rhs(0.3, y).cwiseAbs().maxCoeff();
      EXPECT_LT((declared.col(i) - differenced).cwiseAbs().maxCoeff(), 1e-8 * size + rounding)
          << "column " << i;
    }
  }
}

// Right rows have their initial values at the end: their values at t = 0 are part of the solution.
TEST_P(EveryScene, ItsExactSolutionStartsAtTheInitialValues) {
  if (!scene_.reference.at || is_two_sided(scene_.problem)) GTEST_SKIP();
  EXPECT_LT(
      (scene_.reference.at(0.0).value - columns_at(scene_.outputs, 0.0, taylor_part(scene_.problem, 0.0)))
          .cwiseAbs()
          .maxCoeff(),
      1e-15);
}

TEST_P(EveryScene, IsApproachedByTheMostAccurateScheme) {
  Scene scene = scene_;
  scene.problem.end = std::min(scene.problem.end, 8.0);
  const auto path = solve("product_trapezoidal", scene.problem, 4096);
  ASSERT_EQ(path.status, SolveStatus::finished);
  const reference::ReferenceValue known = reference_of(scene).at(scene.problem.end);
  EXPECT_LT((columns_of(scene.outputs, path).rightCols(1) - known.value).cwiseAbs().maxCoeff(), 2e-4);
  EXPECT_LT(known.bound.maxCoeff(), 1e-9);
}

// dE/dt = power + shares times the rates of columns, along solutions: the chain rule with y' taken from the
// reference.
TEST_P(EveryScene, ItsPowerIsTheRateOfEnergy) {
  if (!scene_.energy.power) GTEST_SKIP();
  const reference::Reference reference = reference_of(scene_);
  for (const double t : {0.7, 3.0, 9.0}) {
    constexpr double h = 1e-3;
    const auto rate_of = [&](const auto& value) {
      const auto at = [&](double time) { return value(reference.at(time).value); };
      return (8.0 * (at(t + h) - at(t - h)) - (at(t + 2 * h) - at(t - 2 * h))) / (12.0 * h);
    };
    const Vec columns = reference.at(t).value;
    Vec shares(std::ssize(scene_.energy.differentiated_columns));
    if (shares.size() > 0) scene_.energy.rate_coefficients(t, columns, shares);
    double power = scene_.energy.power(t, columns);
    for (Eigen::Index k = 0; k < shares.size(); ++k) {
      const Eigen::Index rated = scene_.energy.differentiated_columns[static_cast<std::size_t>(k)];
      power += shares[k] * rate_of([rated](const Vec& at) { return at[rated]; });
    }
    EXPECT_NEAR(rate_of(scene_.energy.value), power, 1e-9) << "t = " << t;
  }
}

std::vector<const SceneFactory*> every_scene() {
  std::vector<const SceneFactory*> all;
  for (const auto& factory : built_in_scenes()) all.push_back(&factory);
  return all;
}
INSTANTIATE_TEST_SUITE_P(, EveryScene, testing::ValuesIn(every_scene()), id_of_param);

TEST(SceneRegistry, HaveTheColumnsOfTheContract) {
  const std::vector<std::string> chain{"phi", "Dbeta_phi", "dphi", "Dalpha_phi"};
  EXPECT_EQ(scene_of("pendulum").outputs.names, chain);
  EXPECT_EQ(scene_of("bagley_torvik").outputs.names, (std::vector<std::string>{"y", "dy", "Dalpha_y"}));
  EXPECT_EQ(scene_of("extensible_pendulum").outputs.names,
            (std::vector<std::string>{"phi", "Dbeta_phi", "dphi", "Dalpha_phi", "xi", "Dbeta_xi", "dxi",
                                      "Dalpha_xi"}));
}

// D^0.5 x = -x + y, D^1.5 y = -4 x - 4: from x(0) = 1 and y(0) = 0 x has the powers 1/2, 1, 3/2, but y has
// none below 3/2, which gives x the power 2; at (-1, -1) the system is at rest.
TEST(SceneRegistry, ALinearSystemStartsWithThePowersOfItsSeries) {
  const ParameterValues values{{"gamma1", 0.5}, {"gamma2", 1.5}, {"a21", -4.0},
                               {"a22", 0.0},    {"c2", -4.0},    {"y0", 0.0}};
  const auto powers = scene_of("linear_system", values).smoothness.powers;
  EXPECT_EQ(powers[0], (std::vector{0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5}));
  EXPECT_EQ(powers[1], (std::vector{1.5, 2.0, 2.5, 3.0, 3.5}));
  auto rest = values;
  rest["x0"] = rest["y0"] = -1.0;
  for (const auto& none : scene_of("linear_system", rest).smoothness.powers) EXPECT_TRUE(none.empty());
}

TEST(SceneRegistry, LeaveOutTheColumnsOfDroppedTerms) {
  EXPECT_EQ(scene_of("pendulum", {{"mu", 0.0}}).outputs.names,
            (std::vector<std::string>{"phi", "Dbeta_phi", "dphi"}));
  EXPECT_EQ(scene_of("pendulum", {{"mu", 0.0}, {"nu", 0.0}}).problem.components.size(), 2U);
}

// With alpha = 1 and beta = 0 the pendulum is u'' + (lambda + mu) tau u' + nu u + sin u = 0: no memory is
// left.
TEST(SceneRegistry, AtWholeOrdersThePendulumIsAnOrdinaryEquation) {
  const auto scene = scene_of("pendulum", {{"alpha", 1.0}, {"beta", 0.0}});
  ASSERT_EQ(scene.problem.components.size(), 2U);
  for (const auto& component : scene.problem.components) EXPECT_EQ(component.order, 1.0);
}

struct Bad {
  const char *scene, *name;
  double value;
  const char* message;
};

class BadParameter : public testing::TestWithParam<Bad> {};

TEST_P(BadParameter, IsNamedWithWhatIsAllowed) {
  const Bad& bad = GetParam();
  EXPECT_EQ(message_of<std::invalid_argument>([&] {
              scene_of(bad.scene, {{bad.name, bad.value}});
            }),
            bad.message);
}

INSTANTIATE_TEST_SUITE_P(
    , BadParameter,
    testing::Values(Bad{"relaxation", "gamma", 0.0, "gamma = 0: must be a number in (0, 2]"},
                    Bad{"relaxation", "gamma", 2.5, "gamma = 2.5: must be a number in (0, 2]"},
                    Bad{"relaxation", "gamma", std::nan(""), "gamma = nan: must be a number in (0, 2]"},
                    Bad{"relaxation", "dy0", 1.0, "dy0 = 1: must be 0 when gamma is at most 1"},
                    Bad{"linear_system", "dx0", 1.0, "dx0 = 1: must be 0 when gamma1 is at most 1"},
                    Bad{"relaxation", "lambda", INFINITY, "lambda = inf: must be a finite number"},
                    Bad{"relaxation", "gama", 0.5,
                        "gama: scene relaxation has no such parameter, did you mean 'gamma'?; it has gamma, "
                        "lambda, y0, dy0"},
                    Bad{"pendulum", "tau", -1.0, "tau = -1: must be a finite number above 0"},
                    Bad{"pendulum", "alpha", 2.5, "alpha = 2.5: must be a number in [1, 2]"},
                    Bad{"power", "p", 0.25,
                        "p = 0.25: must be at least gamma: the right-hand side is infinite at 0 otherwise"},
                    Bad{"extensible_pendulum", "xi0", -1.0, "xi0 = -1: must be a finite number above -1"}),
    [](const auto& test) {
      return std::string(test.param.scene) + "__" + test.param.name + "__" + std::to_string(test.index);
    });

}  // namespace
}  // namespace fde::bench
