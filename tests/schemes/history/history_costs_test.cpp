// SPDX-License-Identifier: MIT
// The estimated costs of direct sums and of exponentials, and the choice that follows from them.

#include "fdebench/schemes/history/history_costs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "fdebench/schemes/history/exponential_memory.hpp"
#include "fdebench/schemes/problem/grid.hpp"

namespace fde::bench {
namespace {

constexpr double full = 1e-15;

WeightTables tables_of(const std::vector<const WeightFamily*>& families, std::size_t components,
                       double order = 0.5) {
  WeightTables tables;
  for (const auto* family : families) tables.emplace_back(components, WeightTable{family, order});
  return tables;
}

WeightTables l1_of(std::size_t components) { return tables_of({&families::l1}, components); }

StepPlan steps_of(int count, double grading = 1.0) { return step_plan({1.0, count, grading}); }

ChosenHistory choice(const WeightTables& tables, const StepPlan& steps, double tolerance = full) {
  return choose_history(HistoryKind::automatic, tables, steps, tolerance);
}

HistoryKind chosen(const WeightTables& tables, const StepPlan& steps) { return choice(tables, steps).kind; }

TEST(HistoryCosts, GrowWithTheSquareOfTheStepsOrWithTheSteps) {
  constexpr int many = 1 << 17;
  for (const double grading : {1.0, 2.0}) {
    const auto once = history_costs(l1_of(4), steps_of(many, grading), full);
    const auto twice = history_costs(l1_of(4), steps_of(2 * many, grading), full);
    EXPECT_NEAR(twice.direct.time / once.direct.time, 4.0, 0.2);
    EXPECT_NEAR(twice.exponentials.time / once.exponentials.time, 2.0, 0.2);
  }
}

TEST(HistoryCosts, GrowWithStepsComponentsAndSums) {
  for (const double grading : {1.0, 3.0}) {
    for (const std::size_t components : {1, 63, 64, 100'000}) {
      for (const int steps : {8, 31, 32, 500}) {
        const auto costs = history_costs(l1_of(components), steps_of(steps, grading), full);
        for (const auto& more : {history_costs(l1_of(components), steps_of(steps + 1, grading), full),
                                 history_costs(l1_of(components + 100), steps_of(steps, grading), full),
                                 history_costs(tables_of({&families::l1, &families::trapezoid}, components),
                                               steps_of(steps, grading), full)}) {
          EXPECT_GT(more.direct.time, costs.direct.time);
          EXPECT_GT(more.exponentials.time, costs.exponentials.time);
        }
      }
    }
  }
}

// The estimated memory is what the history of a run allocates.
TEST(HistoryCosts, EstimateTheMemoryOfEachKind) {
  for (const auto& family : {&families::l1, &families::grunwald_letnikov, &families::bdf2}) {
    for (const double grading : {1.0, 2.0}) {
      if (grading != 1.0 && family->endpoint_values == nullptr) continue;
      for (const int steps : {20, 40, 300}) {
        const auto tables = tables_of({family}, 2000);
        const auto plan = steps_of(steps, grading);
        const auto costs = history_costs(tables, plan, full);
        const auto ratio = [&](HistoryKind kind, const HistoryCost& estimated) {
          const auto history = make_history(kind, tables, plan, full);
          for (int step = 0; step < steps; ++step)  // some arrays appear in steps
            history->push(plan.end * step / steps, Vec::Zero(2000));
          return estimated.bytes / static_cast<double>(history->bytes());
        };
        EXPECT_NEAR(ratio(HistoryKind::direct, costs.direct), 1.0, 0.1)
            << family->id << grading << ' ' << steps;
        EXPECT_NEAR(ratio(HistoryKind::exponentials, costs.exponentials), 1.0, 0.2)
            << family->id << grading << ' ' << steps;
      }
    }
  }
}

// A million unknowns over 40 steps: exponentials are estimated to be little quicker, and need 1.0 GB for 0.3.
TEST(AutomaticHistory, SavesMemoryWhereThatTakesLittleTime) {
  const auto choice_for = [](std::size_t components, int steps) {
    return choice(l1_of(components), steps_of(steps));
  };
  EXPECT_EQ(choice_for(1'000'000, 40).kind, HistoryKind::direct);
  EXPECT_TRUE(choice_for(1'000'000, 40).for_memory);
  EXPECT_FALSE(choice_for(20'000, 40).for_memory) << "of small runs only the time counts";
  EXPECT_EQ(choice_for(1'000'000, 1000).kind, HistoryKind::exponentials);
  EXPECT_FALSE(choice_for(1'000'000, 1000).for_memory) << "exponentials are faster too";
}

// From the first complete block on, a choice of exponentials is final: direct sums grow faster with the
// number of steps and of components.
TEST(AutomaticHistory, TurnsFromDirectSumsToExponentialsOnce) {
  for (const double grading : {1.0, 2.0}) {
    for (const auto& sums : {std::vector{&families::l1}, {&families::rectangle, &families::trapezoid}}) {
      std::vector<int> crossings;
      for (const std::size_t components : {1, 4, 16, 64, 256, 1024, 16'384}) {
        const WeightTables tables = tables_of(sums, components);
        int crossing = 0;
        for (int steps = 32; steps <= 2048; ++steps) {
          const bool direct = chosen(tables, steps_of(steps, grading)) == HistoryKind::direct;
          EXPECT_FALSE(direct && crossing > 0) << components << ' ' << steps;
          if (!direct && crossing == 0) crossing = steps;
        }
        EXPECT_GT(crossing, 0);
        crossings.push_back(crossing);
      }
      EXPECT_TRUE(std::ranges::is_sorted(crossings, std::greater())) << testing::PrintToString(crossings);
    }
  }
}

// Where weights follow from recurrences and there is one component, the costs of a step are multiply-adds: n
// of direct sums at step n against those of the exponentials, whose tables are paid once.
TEST(AutomaticHistory, CrossesLaterWhereDirectWeightsAreCheap) {
  const auto crossing = [](const WeightTables& tables) {
    int steps = 32;
    while (chosen(tables, steps_of(steps)) == HistoryKind::direct) ++steps;
    return steps;
  };
  const int closed_form = crossing(l1_of(1)), recurrence = crossing(tables_of({&families::bdf2}, 1));
  EXPECT_GT(recurrence, 4 * closed_form);
  EXPECT_GT(crossing(tables_of({&families::bdf6}, 1)), recurrence);
  EXPECT_LT(crossing(tables_of({&families::bdf2}, 64)), recurrence);
}

TEST(AutomaticHistory, NeedsNoExponentialsForManyComponentsInAFewSteps) {
  EXPECT_EQ(chosen(l1_of(1000), steps_of(16)), HistoryKind::exponentials);
  EXPECT_EQ(chosen(l1_of(1), steps_of(16)), HistoryKind::direct);
  EXPECT_EQ(chosen(l1_of(1), steps_of(4, 2.0)), HistoryKind::direct);
}

// The kernel of order 1 is constant, and that of order 2 acts on running sums: one exponential for any number
// of steps that differ.
TEST(AutomaticHistory, RemembersWholeOrdersInOneExponential) {
  for (const double whole : {1.0, 2.0}) {
    for (const int steps : {200, 20'000}) {
      EXPECT_EQ(chosen({{{&families::trapezoid, whole}}}, steps_of(steps, 2.0)), HistoryKind::exponentials)
          << whole << ' ' << steps;
    }
  }
}

TEST(AutomaticHistory, IsWhatTheHistoryOfARunSays) {
  for (const int steps : {16, 512}) {
    for (const auto kind : {HistoryKind::automatic, HistoryKind::direct, HistoryKind::exponentials}) {
      EXPECT_EQ(make_history(kind, l1_of(2), steps_of(steps), full)->chosen().kind,
                choose_history(kind, l1_of(2), steps_of(steps), full).kind);
    }
  }
}

}  // namespace
}  // namespace fde::bench
