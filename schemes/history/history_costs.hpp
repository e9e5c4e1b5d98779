// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/history/history.hpp"

namespace fde {

// The estimated time of a whole run with each kind of history, in ns of the machine of docs/history.md: its
// tables, the first touch of its memory, and all steps. The numbers of weights, exponentials and
// multiply-adds follow from the tables and the steps; the times of one of each are measured. The same
// arguments give the same costs everywhere.
struct HistoryCosts {
  double direct, exponentials;
};

// Precondition: all tables have exponentials and, where steps differ, weights for such steps.
HistoryCosts history_costs(const WeightTables& tables, const StepPlan& steps, double tolerance);

}  // namespace fde
