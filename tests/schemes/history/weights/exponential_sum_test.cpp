// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/exponential_sum.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "schemes/history/weights/exact_weights.hpp"

namespace fde::bench {
namespace {

// Half a unit in the last place of a double, relative to it.
constexpr double unit_of_sum = std::numeric_limits<double>::epsilon() / 2;

constexpr std::array tolerances{1e-4, 1e-8, 1e-12, 1e-15};

struct Range {
  double low, high;
};
constexpr Range long_lags{7.0, 1e8};
// The ranges of histories on uniform grids with few, many and very many steps, and on a strongly graded grid.
constexpr std::array ranges{Range{7.0, 64.0}, Range{7.0, 32768.0}, long_lags, Range{1e-12, 1.0}};

// From low to high, both included.
std::vector<double> geometric(double low, double high, double ratio) {
  std::vector<double> times;
  for (double t = low; t < high; t *= ratio) times.push_back(t);
  times.push_back(high);
  return times;
}

Exact value(const Vec& coefficients, const Vec& nodes, const Exact& t) {
  Exact sum = 0;
  for (Eigen::Index m = 0; m < nodes.size(); ++m) sum += coefficients[m] * exp(-nodes[m] * t);
  return sum;
}

double relative_error(const Exact& value, const Exact& exact) {
  return static_cast<double>(abs(value / exact - 1));
}

// The largest ratio of error and allowed error; once NaN it stays NaN.
struct WorstSum {
  double error = 0.0, ratio = 0.0, at = 0.0;
  void update(double candidate, double allowed, double where) {
    if (candidate <= ratio * allowed || std::isnan(ratio)) return;
    *this = {candidate, candidate / allowed, where};
  }
};

class ExponentialSums : public testing::TestWithParam<double> {
 protected:
  // Rounding of the coefficients changes the sum by at most one unit, rounding of the nodes by at most
  // sum c s t exp(-s t) / (t^(a-1) / Gamma(a)) = 1 - a units (the derivative of the kernel). One more unit is
  // for the rounding in extended precision.
  static double rounding(double exponent) { return (3.0 - exponent) * unit_of_sum; }

  // The worst error of the rounded sum, at times that are not multiples of the period of the error in log t.
  static WorstSum worst_error(const ExponentialSum& sum, const Range& range) {
    const Exact a = GetParam(), scale = 1 / tgamma(a);
    const double allowed = sum.bound + rounding(GetParam());
    WorstSum worst;
    for (const double t : geometric(range.low, range.high, 1.6)) {
      const Exact kernel = scale * pow(Exact(t), a - 1);
      worst.update(relative_error(value(sum.coefficients, sum.nodes, t), kernel), allowed, t);
    }
    return worst;
  }

  static Eigen::Index count(double high, double tolerance) {
    return exponential_sum(GetParam(), long_lags.low, high, tolerance).nodes.size();
  }
};

TEST_P(ExponentialSums, AreWithinTheirBound) {
  for (const auto& range : ranges) {
    for (const double tolerance : tolerances) {
      const auto sum = exponential_sum(GetParam(), range.low, range.high, tolerance);
      EXPECT_LE(sum.bound, tolerance);
      const auto worst = worst_error(sum, range);
      EXPECT_LE(worst.ratio, 1.0) << "on [" << range.low << ", " << range.high << "], tolerance " << tolerance
                                  << ": error " << worst.error << ", t = " << worst.at;
    }
  }
}

TEST_P(ExponentialSums, HaveIncreasingNodesAndPositiveCoefficients) {
  for (const auto& range : ranges) {
    for (const double tolerance : tolerances) {
      const auto [nodes, coefficients, bound] = exponential_sum(GetParam(), range.low, range.high, tolerance);
      ASSERT_EQ(nodes.size(), coefficients.size());
      EXPECT_GE(nodes[0], 0.0);
      EXPECT_EQ(std::adjacent_find(nodes.begin(), nodes.end(), std::greater_equal{}), nodes.end());
      EXPECT_TRUE((coefficients.array() > 0.0).all());
    }
  }
}

TEST_P(ExponentialSums, AreShort) { EXPECT_LE(count(long_lags.high, 1e-15), 90); }

INSTANTIATE_TEST_SUITE_P(, ExponentialSums,
                         testing::Values(1e-9, 0.01, 0.2, 0.5, 0.8, 0.99, 0.999999999, 1.0));

// Close to exponent 1 the kernel is nearly constant: few nodes are needed, and the error is smaller than its
// bound by a factor 1 - a.
class ExponentialSumsAwayFromOne : public ExponentialSums {};

// The tolerance is far above rounding, so that the bound itself is tested.
TEST_P(ExponentialSumsAwayFromOne, HaveABoundThatIsOfUse) {
  for (const auto& range : ranges) {
    const auto sum = exponential_sum(GetParam(), range.low, range.high, 1e-4);
    EXPECT_GT(worst_error(sum, range).ratio, 1e-4) << "on [" << range.low << ", " << range.high << "]";
  }
}

// Each node above the Gauss rule covers the same factor in time; the position of the first is rounded to a
// whole node.
TEST_P(ExponentialSumsAwayFromOne, GrowWithTheLogarithmOfTheLongestTimeOnly) {
  for (const double tolerance : tolerances) {
    const auto growth = count(1e4, tolerance) - count(1e2, tolerance);
    EXPECT_GT(growth, 0);
    for (const double high : {1e6, 1e8}) {
      EXPECT_LE(std::abs(count(high, tolerance) - count(high / 1e2, tolerance) - growth), 1) << high;
    }
  }
}

TEST_P(ExponentialSumsAwayFromOne, AreShorterForALooserTolerance) {
  for (std::size_t i = 1; i < std::size(tolerances); ++i) {
    EXPECT_LT(count(long_lags.high, tolerances[i - 1]), count(long_lags.high, tolerances[i]));
  }
}

INSTANTIATE_TEST_SUITE_P(, ExponentialSumsAwayFromOne, testing::Values(1e-9, 0.01, 0.2, 0.5, 0.8, 0.99));

TEST(ExponentialSum, OfExponentOneIsTheConstantOne) {
  const auto sum = exponential_sum(1.0, 7.0, 1e8, 1e-15);
  EXPECT_EQ(sum.nodes, Vec::Zero(1));
  EXPECT_EQ(sum.coefficients, Vec::Ones(1));
  EXPECT_EQ(sum.bound, 0.0);
}

TEST(ExponentialSum, RefusesBadArgumentsByName) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  struct Bad {
    double exponent, low, high, tolerance;
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const Bad& bad : {Bad{0.0, 7, 64, 1e-8},
                         {-0.5, 7, 64, 1e-8},
                         {1.5, 7, 64, 1e-8},
                         {nan, 7, 64, 1e-8},
                         {0.5, 0, 64, 1e-8},
                         {0.5, -1, 64, 1e-8},
                         {0.5, nan, 64, 1e-8},
                         {0.5, 7, 7, 1e-8},
                         {0.5, 7, 6, 1e-8},
                         {0.5, 7, nan, 1e-8},
                         {0.5, 7, infinity, 1e-8},
                         {0.5, 7, 64, 0},
                         {0.5, 7, 64, 1},
                         {0.5, 7, 64, nan}}) {
    const auto call =
        fmt::format("exponential_sum({}, {}, {}, {})", bad.exponent, bad.low, bad.high, bad.tolerance);
    EXPECT_THAT([&bad] { exponential_sum(bad.exponent, bad.low, bad.high, bad.tolerance); },
                testing::ThrowsMessage<std::invalid_argument>(testing::StartsWith(call)));
  }
}

class WeightTransform : public testing::Test {
 protected:
  static constexpr double longest = 1e7;

  static std::vector<WeightTable> tables(const WeightFamily& family) {
    std::vector<WeightTable> tables;
    for (const double order : {0.01, 0.3, 0.5, 0.9, 1.2, 1.7, 2.0}) {
      if (!family.acts_on_increments || order < 1.0) tables.push_back({&family, order});
    }
    return tables;
  }

  // number(lag), or number(lag) - number(lag - 1) where running sums are weighed.
  template <typename Number>
  static Exact weighed(const WeightTable& table, std::int64_t lag, Number number) {
    return acts_on_running_sums(table) ? Exact(number(lag) - number(lag - 1)) : number(lag);
  }

  // The bound of the sum holds for weights that are means of the kernel. In addition to the rounding of the
  // sum, at most 3 - a units, the factors have 20 units: one for each of five products, three for each of
  // three quotients expm1(s)/s, two for exp and four for Gamma; other families have less.
  static double allowed(double bound) { return bound + 23.0 * unit_of_sum; }

  // Compares the weights from coefficients_of(sum) with exact ones, at lags from the smallest for which a
  // history uses them.
  template <typename Coefficients, typename Number>
  static void expect_weights(const WeightTable& table, Coefficients coefficients_of, Number exact) {
    for (const double tolerance : {1e-6, 1e-15}) {
      const auto sum = exponential_sum(kernel_exponent(table), 7.0, longest + 2.0, tolerance);
      const Vec coefficients = coefficients_of(table, sum);
      WorstSum worst;
      for (const double lag : geometric(9.0, longest, 1.7)) {
        const auto k = static_cast<std::int64_t>(lag);
        const double error = relative_error(value(coefficients, sum.nodes, k), weighed(table, k, exact));
        worst.update(error, allowed(sum.bound), lag);
      }
      EXPECT_LE(worst.ratio, 1.0) << "order " << table.order << ", tolerance " << tolerance << ": error "
                                  << worst.error << ", k = " << worst.at;
    }
  }
};

class WeightTransforms : public WeightTransform, public testing::WithParamInterface<const WeightFamily*> {};

TEST_P(WeightTransforms, GiveTheWeights) {
  for (const auto& table : tables(*GetParam())) {
    expect_weights(table, weight_coefficients, [&](std::int64_t k) { return published_weight(table, k); });
  }
}

INSTANTIATE_TEST_SUITE_P(, WeightTransforms,
                         testing::Values(&families::rectangle, &families::trapezoid,
                                         &families::grunwald_letnikov, &families::l1, &families::l2_1_sigma),
                         [](const auto& test) { return std::string(test.param->id); });

// These weights are differences of means over the two halves of a step, so their error is relative to the sum
// of both means.
TEST_F(WeightTransform, GivesBendsAsWellAsTheLinesBesideThem) {
  for (const auto& [bend, line] : {std::pair{&families::l1_second_difference, &families::l1},
                                   {&families::l2_1_sigma_second_difference, &families::l2_1_sigma}}) {
    for (const auto& table : tables(*bend)) {
      for (const double tolerance : {1e-6, 1e-15}) {
        const auto sum = exponential_sum(kernel_exponent(table), 7.0, longest + 2.0, tolerance);
        const Vec coefficients = weight_coefficients(table, sum);
        for (const double lag : geometric(9.0, longest, 1.7)) {
          const auto k = static_cast<std::int64_t>(lag);
          const Exact error = abs(value(coefficients, sum.nodes, k) - published_weight(table, k));
          EXPECT_LE(error, allowed(sum.bound) * published_weight({line, table.order}, k))
              << bend->id << ", order " << table.order << ", k = " << k;
        }
      }
    }
  }
}

TEST_F(WeightTransform, GivesTheStartWeightsOfTheTrapezoidalRule) {
  for (const auto& table : tables(families::trapezoid)) {
    expect_weights(table, first_sample_coefficients,
                   [&](std::int64_t n) { return published_first_sample_weight(table.order, n); });
  }
}

}  // namespace
}  // namespace fde::bench
