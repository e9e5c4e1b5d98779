// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/chain.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "fdebench/schemes/stepping/order_splitting.hpp"
#include "support/matchers.hpp"

namespace fde::bench {
namespace {

using testing::DoubleNear;
using testing::Pointwise;

const std::vector<Term> damping_terms{{0.1, 0.5}, {0.2, 1.0}, {0.3, 1.5}};

std::vector<double> orders_of(const std::vector<Component>& components) {
  std::vector<double> result;
  for (const auto& component : components) result.push_back(component.order);
  return result;
}

std::vector<double> starts(const std::vector<Component>& components) {
  std::vector<double> result;
  for (const auto& component : components) result.push_back(component.initial.front());
  return result;
}

// Yin, Liu & Anh 2007, eqs 5.4, 5.5.
TEST(Chain, OfThePendulumHasFourLinksAndItsInitialValuesAtWholeNodes) {
  const Chain chain({1.0, 2.0}, damping_terms, {1.0, -0.3});
  EXPECT_THAT(chain.nodes(), ElementsAre(0.0, 0.5, 1.0, 1.5));
  EXPECT_THAT(orders_of(chain.components()), ElementsAre(0.5, 0.5, 0.5, 0.5));
  EXPECT_THAT(starts(chain.components()), ElementsAre(1.0, 0.0, -0.3, 0.0));
}

// D^beta of order close to 0 is u - u(0), not u: it has its own node, which starts at 0.
TEST(Chain, KeepsTheSmallestOrdersApart) {
  const Chain chain({1.0, 2.0}, {{0.1, 1e-15}}, {1.0, -0.3});
  EXPECT_THAT(chain.nodes(), ElementsAre(0.0, 1e-15, 1.0));
  EXPECT_THAT(starts(chain.components()), ElementsAre(1.0, 0.0, -0.3));
}

TEST(Chain, DropsZeroTermsAndKeepsWholeOrders) {
  const Chain chain({1.0, 2.0}, {{0.0, 0.5}, {0.0, 1.0}, {0.3, 1.5}}, {1.0, -0.3});
  EXPECT_THAT(chain.nodes(), ElementsAre(0.0, 1.0, 1.5));
  EXPECT_EQ(chain.row(0.5), std::nullopt);
  EXPECT_EQ(Chain({1.0, 2.0}, {}, {1.0, 0.0}).components().size(), 2U);
}

TEST(Chain, MergesTermsOfOneOrder) {
  const Chain chain({1.0, 2.0}, {{0.1, 0.5}, {0.2, 0.5}, {0.4, 0.0}}, {1.0, 0.0});
  EXPECT_THAT(chain.nodes(), ElementsAre(0.0, 0.5, 1.0));
  EXPECT_LT((chain.coefficients() - Eigen::Vector3d(0.4, 0.3, 0.0)).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(Chain, RefusesTermsThatAreNotBelowTheLeadingOrder) {
  EXPECT_THROW(Chain({1.0, 2.0}, {{1.0, 2.0}}, {0.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(Chain({0.0, 2.0}, {}, {0.0, 0.0}), std::invalid_argument);
}

// u'' = c + t^(1/2) + ... for (1.5, 0.5): D^beta u starts like t^(1-beta), D^alpha u
// like t^(2-alpha).
TEST(ChainSmoothness, OfThePendulum) {
  const auto smoothness = smoothness_of_chains({Chain({1.0, 2.0}, damping_terms, {1.0, -0.3})});
  EXPECT_THAT(smoothness.powers[0], ElementsAre(1.0, 2.0, 2.5, 3.0, 3.5, 4.0));
  EXPECT_DOUBLE_EQ(smoothness.powers[1].front(), 0.5);
  EXPECT_THAT(smoothness.powers[2].front(), DoubleNear(1.0, 1e-15));
  EXPECT_DOUBLE_EQ(smoothness.powers[3].front(), 0.5);
}

TEST(ChainSmoothness, WithoutInitialVelocityTheLowerDerivativeIsSmoother) {
  const auto smoothness = smoothness_of_chains({Chain({1.0, 2.0}, damping_terms, {1.0, 0.0})});
  EXPECT_DOUBLE_EQ(smoothness.powers[0].front(), 2.0);
  EXPECT_DOUBLE_EQ(smoothness.powers[1].front(), 1.5);
}

Problem order_and_half() {
  return {.components = {{1.5, {1.0, 2.0}}, {0.5, {3.0}}}, .rhs = [](double, In y, Out f) { f = -y; }};
}

TEST(Splitting, OrdersAboveOneBecomeLinks) {
  const auto links = splitting_up_to_one(order_and_half());
  EXPECT_THAT(links, ElementsAre(ElementsAre(1.0, 0.5), ElementsAre(0.5)));
  const auto problem = split_orders(order_and_half(), links);
  EXPECT_THAT(orders_of(problem.components), ElementsAre(1.0, 0.5, 0.5));
  EXPECT_THAT(starts(problem.components), ElementsAre(1.0, 2.0, 3.0));
  Vec f(3);
  problem.rhs(0.0, (Vec(3) << 5.0, 6.0, 7.0).finished(), f);
  EXPECT_EQ(f, (Vec(3) << 6.0, -5.0, -7.0).finished());
}

// The paper's objection to the commensurate expansion: orders (1.9, 0.1) give 20 states, the chain has 4.
TEST(Splitting, TheCommensurateExpansionHasManyStates) {
  const Chain chain({1.0, 2.0}, {{0.1, 0.1}, {0.3, 1.9}}, {1.0, -0.3});
  const Problem problem{.components = chain.components(), .rhs = {}};
  const auto links = commensurate_splitting(problem).value();
  EXPECT_EQ(split_orders(problem, links).components.size(), 20U);
  const Problem eighths{.components = {{0.375, {0.0}}, {1.0, {0.0}}}, .rhs = {}};
  EXPECT_THAT(commensurate_splitting(eighths)->at(0), Pointwise(DoubleNear(1e-15), {0.125, 0.125, 0.125}));
}

}  // namespace
}  // namespace fde::bench
