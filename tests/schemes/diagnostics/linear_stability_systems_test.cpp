// SPDX-License-Identifier: MIT
// Growing modes of systems, compared with those of their parts.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

#include "fdebench/schemes/diagnostics/stability_region.hpp"
#include "fdebench/schemes/problem/scalar_equation.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// One problem of uncoupled equations.
Problem side_by_side(const std::vector<Problem>& parts) {
  Problem all;
  Eigen::Index size = 0;
  for (const auto& part : parts) size += part.size();
  Matrix linear = Matrix::Zero(size, size);
  Eigen::Index first = 0;
  for (const auto& part : parts) {
    all.components.insert(all.components.end(), part.components.begin(), part.components.end());
    linear.block(first, first, part.size(), part.size()) = std::get<DenseLinearPart>(part.derivatives).matrix;
    first += part.size();
  }
  all.derivatives = DenseLinearPart{linear};
  return all;
}

class Systems : public testing::TestWithParam<const Scheme*> {};

// The orders are odd multiples of 1/4, which the commensurate scheme splits in the same way alone and
// together.
TEST_P(Systems, OfSeparateEquationsHaveTheModesOfAll) {
  std::mt19937 random(7);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const int most = GetParam()->id == "commensurate_adams_pc" ? 2 : 5;  // each has up to 14 links there
  int growing = 0;
  for (int i = 0; i < 8; ++i) {
    std::vector<Problem> parts;
    int sum = 0;
    for (int left = std::uniform_int_distribution(1, most)(random); left > 0; --left) {
      const double order = 0.5 * std::uniform_int_distribution(0, 3)(random) + 0.25;
      parts.push_back(
          scalar_equation(order, std::polar(std::pow(10.0, uniform(-2.0, 1.5)), uniform(-3.14, 3.14))));
      sum += count_growing_modes(*GetParam(), parts.back(), 1.0).value();
    }
    EXPECT_EQ(count_growing_modes(*GetParam(), side_by_side(parts), 1.0), sum) << i;
    growing += sum;
  }
  EXPECT_GT(growing, 8);
}

INSTANTIATE_TEST_SUITE_P(Schemes, Systems, testing::ValuesIn(row_schemes()), id_of_param);

// Small link orders need 1 - zeta = 1e-300, powers of which overflow.
TEST(Systems, OfLinksNearOrdersZeroAndOneAreStableUnderImplicitRules) {
  for (const auto& orders : {std::pair{1.99, 0.01}, {1.999, 0.001}}) {
    const Problem problem =
        scene_of("damped_oscillator", {{"alpha", orders.first}, {"beta", orders.second}}).problem;
    for (const auto* id : {"l1", "grunwald_letnikov", "product_trapezoidal"}) {
      for (const double h : {0.1, 1e9})
        EXPECT_EQ(count_growing_modes(*find_scheme(id), problem, h), 0) << id << orders.first << ' ' << h;
    }
  }
}

// Equal equations, each with the modes of one. The determinant at 1 - zeta = 1e-12 would be 1e456.
TEST(Systems, MayBeLarge) {
  constexpr int count = 20;
  const auto modes = [](int n, double rate) {
    return count_growing_modes(
               *find_scheme("grunwald_letnikov"),
               side_by_side(std::vector(static_cast<std::size_t>(n), scalar_equation(1.9, rate))), 1.0)
        .value();
  };
  EXPECT_EQ(modes(count, -1.0), 0);
  EXPECT_EQ(modes(count, 0.5), count * modes(1, 0.5));
}

// A sparse linear part. The most negative eigenvalue is the first to leave the real stability interval.
TEST(Systems, OfDiffusionAreStableAsTheirFastestRate) {
  const Problem problem = scene_of("fractional_diffusion", {{"gamma", 0.5}, {"components", 9.0}}).problem;
  const Matrix linear = std::get<SparseLinearPart>(problem.derivatives).matrix;
  const double fastest = -linear.selfadjointView<Eigen::Lower>().eigenvalues()[0];
  const double end = std::pow(real_stability_interval(*find_scheme("adams_pc"), 0.5) / fastest, 2.0);
  EXPECT_EQ(count_growing_modes(*find_scheme("adams_pc"), problem, 0.99 * end), 0);
  EXPECT_EQ(count_growing_modes(*find_scheme("adams_pc"), problem, 1.01 * end), 1);
  EXPECT_EQ(count_growing_modes(*find_scheme("l1"), problem, 1e3 * end), 0);
}

// Modes with |lambda h^g| below max(1e-6, 1e-300^g) are not counted.
TEST(GrowingModes, OfSmallOrdersAreCountedFromTheirLimitOn) {
  const auto& scheme = *find_scheme("l1");
  EXPECT_EQ(count_growing_modes(scheme, scalar_equation(0.5, 2e-6), 1.0), 1);
  EXPECT_EQ(count_growing_modes(scheme, scalar_equation(0.5, 5e-7), 1.0), 0);
  EXPECT_EQ(count_growing_modes(scheme, scalar_equation(0.01, 1.1e-3), 1.0), 1);
  EXPECT_EQ(count_growing_modes(scheme, scalar_equation(0.01, 9e-4), 1.0), 0);
}

TEST(GrowingModes, AreNotCountedBeyondDouble) {
  expect_message([] { count_growing_modes(*find_scheme("l1"), scalar_equation(1.5, -1e300), 1e10); },
                 "beyond double");
}

}  // namespace
}  // namespace fde::bench
