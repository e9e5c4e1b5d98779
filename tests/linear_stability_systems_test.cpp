// Growing modes of systems, from what is known of their parts.

#include <gtest/gtest.h>

#include <random>

#include "growing_modes.hpp"
#include "scalar_equation.hpp"
#include "testing.hpp"

namespace fde {
namespace {

// Equations that do not know of each other.
Problem side_by_side(const std::vector<Problem>& parts) {
  Problem all{.linear_part = Matrix()};
  Eigen::Index size = 0;
  for (const auto& part : parts) size += part.size();
  all.linear_part->setZero(size, size);
  Eigen::Index first = 0;
  for (const auto& part : parts) {
    all.components.insert(all.components.end(), part.components.begin(), part.components.end());
    all.linear_part->block(first, first, part.size(), part.size()) = *part.linear_part;
    first += part.size();
  }
  return all;
}

class Systems : public testing::TestWithParam<const Scheme*> {};

// Multiples of 1/4 are orders for the commensurate scheme too.
TEST_P(Systems, OfSeparateEquationsHaveTheModesOfAll) {
  std::mt19937 random(7);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  int growing = 0;
  for (int i = 0; i < 30; ++i) {
    std::vector<Problem> parts;
    int sum = 0;
    for (int left = std::uniform_int_distribution(1, 9)(random); left > 0; --left) {
      const double order = 0.25 * std::uniform_int_distribution(1, 7)(random);
      parts.push_back(
          scalar_equation(order, std::polar(std::pow(10.0, uniform(-2.0, 1.5)), uniform(-3.14, 3.14))));
      sum += growing_modes(*GetParam(), parts.back(), 1.0).value();
    }
    EXPECT_EQ(growing_modes(*GetParam(), side_by_side(parts), 1.0), sum) << i;
    growing += sum;
  }
  EXPECT_GT(growing, 100);
}

INSTANTIATE_TEST_SUITE_P(Schemes, Systems, testing::ValuesIn(all_schemes()), id_of_param);

// Small link orders are felt where 1 - zeta is 1e-300: powers of it leave double.
TEST(Systems, OfLinksNearOrdersZeroAndOneAreStableUnderImplicitRules) {
  for (const auto& orders : {std::pair{1.99, 0.01}, {1.999, 0.001}, {1.01, 0.99}}) {
    const Problem problem =
        scene_of("damped_oscillator", {{"alpha", orders.first}, {"beta", orders.second}}).problem;
    for (const auto* id : {"l1", "grunwald_letnikov", "product_trapezoidal"}) {
      for (const double h : {1e-6, 0.1, 3.0, 1e3, 1e9})
        EXPECT_EQ(growing_modes(*find_scheme(id), problem, h), 0) << id << orders.first << ' ' << h;
    }
  }
}

// n equal equations: each has the modes of one.
TEST(Systems, MayBeLarge) {
  const auto& scheme = *find_scheme("grunwald_letnikov");
  for (const auto& [order, count] : {std::pair{1.9, 20}, {1.0, 40}, {0.5, 80}}) {
    const auto modes = [&](int n, double rate) {
      return growing_modes(scheme, side_by_side(std::vector(n, scalar_equation(order, rate))), 1.0).value();
    };
    EXPECT_EQ(modes(count, -1.0), 0) << order;
    EXPECT_EQ(modes(count, 0.5), count * modes(1, 0.5)) << order;
  }
}

// The sparse linear part of a scene; every rate is real and negative, the largest near -4 K sites^2.
TEST(Systems, OfDiffusionAreStableWithinTheRealInterval) {
  const Problem problem = scene_of("fractional_diffusion", {{"sites", 9.0}}).problem;
  EXPECT_EQ(growing_modes(*find_scheme("l1"), problem, 1.0), 0);
}

// Slow modes are those below max(1e-6, 1e-300^g).
TEST(GrowingModes, OfSmallOrdersAreCountedFromTheirLimitOn) {
  const auto& scheme = *find_scheme("l1");
  EXPECT_EQ(growing_modes(scheme, scalar_equation(0.5, 2e-6), 1.0), 1);
  EXPECT_EQ(growing_modes(scheme, scalar_equation(0.5, 5e-7), 1.0), 0);
  EXPECT_EQ(growing_modes(scheme, scalar_equation(0.01, 1.1e-3), 1.0), 1);
  EXPECT_EQ(growing_modes(scheme, scalar_equation(0.01, 9e-4), 1.0), 0);
}

TEST(GrowingModes, AreNotCountedBeyondDouble) {
  expect_message([] { growing_modes(*find_scheme("l1"), scalar_equation(1.5, -1e300), 1e10); },
                 "beyond double");
}

}  // namespace
}  // namespace fde
