#include "history.hpp"

#include <gtest/gtest.h>

#include <random>

#include "trajectory.hpp"

namespace fde {
namespace {

// The definition, term by term in extended precision.
double by_definition(const WeightTable& table, const Rows& samples, Eigen::Index component) {
  const auto n = samples.cols();
  long double sum =
      static_cast<long double>(start_weight(table, n).value_or(weight(table, n))) * samples(component, 0);
  for (Eigen::Index j = 1; j < n; ++j) {
    sum += static_cast<long double>(weight(table, n - j)) * samples(component, j);
  }
  return static_cast<double>(sum);
}

Rows random_samples(Eigen::Index components, Eigen::Index count) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(0.5, 1.5);
  return Rows::NullaryExpr(components, count, [&] { return uniform(generator); });
}

class Histories : public testing::TestWithParam<HistoryKind> {};

TEST_P(Histories, ConvolveAsDefinedAtEveryStep) {
  constexpr Eigen::Index steps = 100;
  const WeightTables tables{
      {{WeightFamily::rectangle, 0.3}, {WeightFamily::rectangle, 1.0}, {WeightFamily::rectangle, 1.7}},
      {{WeightFamily::trapezoid, 0.3}, {WeightFamily::trapezoid, 1.0}, {WeightFamily::trapezoid, 1.7}},
      {{WeightFamily::grunwald_letnikov, 0.3},
       {WeightFamily::grunwald_letnikov, 1.0},
       {WeightFamily::l1, 0.4}},
      {{WeightFamily::l1, 0.3}, {WeightFamily::l1, 1.0}, {WeightFamily::trapezoid, 0.01}}};
  const Rows samples = random_samples(3, steps);
  const auto history = make_history(GetParam(), tables, {1.0, steps}, 1e-15);
  Vec result(3);
  for (Eigen::Index n = 1; n <= steps; ++n) {
    history->push(samples.col(n - 1));
    for (std::size_t sum = 0; sum < tables.size(); ++sum) {
      history->convolve(sum, result);
      for (Eigen::Index i = 0; i < 3; ++i) {
        const double expected =
            by_definition(tables[sum][static_cast<std::size_t>(i)], samples.leftCols(n), i);
        EXPECT_NEAR(result[i], expected, 1e-14 * std::abs(expected))
            << "sum " << sum << ", component " << i << ", n " << n;
      }
    }
  }
}

TEST_P(Histories, OrderOneNeedsNoMemoryForItsPast) {
  const WeightTables order_one{{{WeightFamily::trapezoid, 1.0}}},
      order_half{{{WeightFamily::trapezoid, 0.5}}};
  EXPECT_LT(make_history(GetParam(), order_one, {1.0, 1000}, 1e-15)->bytes(), 100U);
  EXPECT_GT(make_history(GetParam(), order_half, {1.0, 1000}, 1e-15)->bytes(), 1000U);
}

TEST_P(Histories, EqualOrdersShareTheirWeights) {
  const WeightTable half{WeightFamily::trapezoid, 0.5}, third{WeightFamily::trapezoid, 0.3};
  EXPECT_LT(make_history(GetParam(), {{half, half}}, {1.0, 1000}, 1e-15)->bytes(),
            make_history(GetParam(), {{half, third}}, {1.0, 1000}, 1e-15)->bytes());
}

INSTANTIATE_TEST_SUITE_P(, Histories,
                         testing::Values(HistoryKind::automatic, HistoryKind::direct,
                                         HistoryKind::exponentials),
                         [](const auto& test) { return std::string(name(test.param)); });

}  // namespace
}  // namespace fde
