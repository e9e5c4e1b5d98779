// SPDX-License-Identifier: MIT
// Histories of many components, with any number of threads, give the same bits as each component alone, or
// the same up to rounding where weights have a filter, which is applied in another way to few components.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "fdebench/schemes/history/exponential_memory.hpp"
#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/history/parallel_for_rows.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde::bench {
namespace {

constexpr int wide_steps = 200;

struct Family {
  std::string name;
  std::vector<WeightTable> tables;  // one a sum
};

std::vector<Family> families_of_histories() {
  return {{"l1", {{&families::l1, 0.4}}},
          {"adams", {{&families::rectangle, 0.5}, {&families::trapezoid, 0.5}}},
          {"above_one", {{&families::rectangle, 1.6}, {&families::trapezoid, 1.6}}},
          {"filtered", {{&families::bdf2, 0.7}}},
          {"alternating", {{&families::fractional_trapezoidal, 0.3}}}};
}

double sample_of(Eigen::Index component, int n) {
  return std::sin(0.1 * n * static_cast<double>(component % 7 + 1)) +
         0.01 * static_cast<double>(component % 91);
}

// The memory sums of a history of the components from `first` on: one column a step, the sums stacked.
Rows sums(const Family& family, Eigen::Index first, Eigen::Index components, int threads) {
  WeightTables tables;
  for (const auto& table : family.tables) tables.emplace_back(static_cast<std::size_t>(components), table);
  const auto history =
      make_history(HistoryKind::exponentials, tables, step_plan({.end = 1.0, .steps = wide_steps}), 1e-15);
  const RowThreads several(threads);
  Rows result(std::ssize(tables) * components, wide_steps);
  for (int n = 0; n < wide_steps; ++n) {
    history->push(n, Vec::NullaryExpr(components, [&](Eigen::Index i) { return sample_of(first + i, n); }));
    for (std::size_t s = 0; s < tables.size(); ++s) {
      history->convolve(n + 1, s,
                        result.col(n).segment(static_cast<Eigen::Index>(s) * components, components));
    }
  }
  return result;
}

// Every part is done once, whichever thread does it.
TEST(SharedWork, DoesEveryRowOnce) {
  for (const int threads : {1, 2, 5}) {
    const RowThreads several(threads);
    for (const Eigen::Index rows : {1, 100, 16'384, 100'001}) {
      std::vector<int> visits(static_cast<std::size_t>(rows), 0);
      for (int round = 0; round < 20; ++round)
        for_each_row(rows, [&](Eigen::Index i) { ++visits[static_cast<std::size_t>(i)]; });
      EXPECT_EQ(std::ranges::count(visits, 20), rows) << threads;
    }
  }
}

TEST(SharedWork, FindsTheOnlyRowThatFails) {
  constexpr Eigen::Index rows = 100'000;
  const RowThreads two(2);
  for (const Eigen::Index failing : {Eigen::Index{0}, rows / 2, rows - 1})
    EXPECT_FALSE(holds_for_each_row(rows, [=](Eigen::Index i) { return i != failing; }));
  EXPECT_TRUE(holds_for_each_row(rows, [](Eigen::Index) { return true; }));
}

class ManyComponents : public testing::TestWithParam<Family> {};

TEST_P(ManyComponents, AreEachAsAlone) {
  constexpr Eigen::Index many = 203;
  static_assert(many > ExponentialMemory::fewest_wide && many % WideMemory::tile % lanes != 0);
  const Rows together = sums(GetParam(), 0, many, 1);
  for (const Eigen::Index i : {0, 7, 63, 64, 130, 202}) {
    const Rows alone = sums(GetParam(), i, 1, 1);
    for (Eigen::Index s = 0; s < alone.rows(); ++s) {
      if (GetParam().tables.front().family->filter == nullptr) {
        EXPECT_EQ(together.row(s * many + i), alone.row(s)) << i;
      } else {
        EXPECT_LT((together.row(s * many + i) - alone.row(s)).cwiseAbs().maxCoeff(), 1e-13) << i;
      }
    }
  }
}

TEST_P(ManyComponents, HaveTheSameBitsInAnyNumberOfThreads) {
  constexpr Eigen::Index many = 30'000;  // enough for three threads
  const Rows one = sums(GetParam(), 0, many, 1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(one, sums(GetParam(), 0, many, threads)) << threads;
}

INSTANTIATE_TEST_SUITE_P(, ManyComponents, testing::ValuesIn(families_of_histories()),
                         [](const auto& test) { return test.param.name; });

TEST(SharedWork, PassesOnWhatAnyThreadThrows) {
  constexpr Eigen::Index rows = 100'000;
  for (const Eigen::Index failing : {Eigen::Index{0}, rows - 1}) {
    const auto work = [=](Eigen::Index first, Eigen::Index count) {
      if (first <= failing && failing < first + count) throw std::runtime_error("no");
    };
    const RowThreads two(2);
    EXPECT_THROW(parallel_for_rows(rows, 1, work), std::runtime_error) << failing;
  }
}

// A run that ends within the first block: all samples have their exact weights.
TEST(WideMemory, NeedsNoExponentialsWithinABlock) {
  const WeightTables tables{std::vector<WeightTable>(100, {&families::trapezoid, 0.5})};
  const auto history = [&](HistoryKind kind, int count) {
    return make_history(kind, tables, step_plan({.end = 1.0, .steps = count}), 1e-15);
  };
  const auto direct = history(HistoryKind::direct, 31), short_run = history(HistoryKind::exponentials, 31);
  EXPECT_LT(4 * short_run->bytes(), 3 * history(HistoryKind::exponentials, 32)->bytes());
  Vec exact(100), sums(100);
  for (int n = 0; n < 31; ++n) {
    const Vec sample = Vec::NullaryExpr(100, [&](Eigen::Index i) { return sample_of(i, n); });
    direct->push(n, sample);
    short_run->push(n, sample);
    direct->convolve(n + 1, 0, exact);
    short_run->convolve(n + 1, 0, sums);
    EXPECT_LE((sums - exact).lpNorm<Eigen::Infinity>(), 1e-14 * (1.0 + exact.lpNorm<Eigen::Infinity>())) << n;
  }
}

// Component i has one sample 1 at step i, so that its sums are the weights. Relative to the larger of |w(k)|
// and k^(g-1) / 1000: filters have zeros.
TEST(WideFilteredMemory, AppliesTheWeights) {
  constexpr Eigen::Index many = 70;
  constexpr int longest = 1200;
  for (const auto* family : {&families::bdf2, &families::bdf3, &families::bdf4, &families::bdf5,
                             &families::bdf6, &families::newton_gregory_2, &families::newton_gregory_3}) {
    for (const double order : {0.01, 0.5, 0.99, 1.0, 1.01, 1.5, 2.0}) {
      const WeightTables tables{std::vector<WeightTable>(many, {family, order})};
      const auto history =
          make_history(HistoryKind::exponentials, tables, step_plan({.end = 1.0, .steps = longest}), 1e-15);
      const Vec weights = first_weights({family, order}, longest);
      Vec sums(many);
      double worst = 0.0;
      for (Eigen::Index n = 0; n < longest; ++n) {
        const auto time = static_cast<double>(n);
        history->push(time, n < many ? Vec(Vec::Unit(many, n)) : Vec(Vec::Zero(many)));
        history->convolve(time + 1.0, 0, sums);
        for (Eigen::Index i = 0; i < many; ++i) {
          const double exact = i <= n ? weights[n - i] : 0.0;
          const double power = std::pow(std::max(time + 1.0 - static_cast<double>(i), 1.0), order - 1.0);
          worst = std::max(worst, std::abs(sums[i] - exact) / std::max(std::abs(exact), 1e-3 * power));
        }
      }
      EXPECT_LT(worst, 1e-14) << family->id << ' ' << order;
    }
  }
}

// The memory a component needs, apart from the memory that does not grow with the number of components.
double bytes_of_a_component(const WeightFamily& family) {
  const auto bytes = [&](std::size_t components) {
    const WeightTables tables{std::vector<WeightTable>(components, {&family, 0.5})};
    return static_cast<double>(
        make_history(HistoryKind::exponentials, tables, step_plan({.end = 1.0, .steps = 1000}), 1e-15)
            ->bytes());
  };
  return (bytes(20'000) - bytes(10'000)) / 10'000;
}

// A thousand samples are 8000 bytes.
TEST(WideMemory, TakesItsStatesAndLittleElse) { EXPECT_LT(bytes_of_a_component(families::l1), 1400.0); }

TEST(WideFilteredMemory, TakesASampleForEachExactWeightAndLittleElse) {
  EXPECT_LT(bytes_of_a_component(families::bdf2), 1400.0);
  EXPECT_LT(bytes_of_a_component(families::bdf6), 2900.0);
}

}  // namespace
}  // namespace fde::bench
