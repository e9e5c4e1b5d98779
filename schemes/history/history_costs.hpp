// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/history/history.hpp"

namespace fde {

// The estimated costs of a whole run with one kind of history. The time is in ns of the machine of
// docs/history.md: its tables, the first touch of its memory, and all steps. The numbers of weights,
// exponentials and multiply-adds follow from the tables and the steps; the times of one of each are measured.
// The memory is that of samples, sums, states and direct weights, without the tables of exponentials, some
// 100 KB.
struct HistoryCost {
  double time = 0.0, bytes = 0.0;

  // The smaller one is preferred: time and memory multiplied, where memory below 256 MB counts as 256 MB, so
  // that of small runs only the time counts.
  [[nodiscard]] double time_and_memory() const;
};
struct HistoryCosts {
  HistoryCost direct{}, exponentials{};
};

// The same arguments give the same costs everywhere.
// Precondition: all tables have exponentials and, where steps differ, weights for such steps.
HistoryCosts history_costs(const WeightTables& tables, const StepPlan& steps, double tolerance);

}  // namespace fde
