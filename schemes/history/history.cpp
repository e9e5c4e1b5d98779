// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "fdebench/schemes/history/direct_history.hpp"
#include "fdebench/schemes/history/exponential_history.hpp"
#include "fdebench/schemes/history/history_costs.hpp"
#include "fdebench/schemes/history/variable_step_history.hpp"
#include "fdebench/schemes/history/weights/exponential_sum.hpp"

namespace fde {
namespace {

// Rounding, and the largest relative error of a weight that is accepted.
constexpr double finest_tolerance = 1e-16, coarsest_tolerance = 0.1;

double achievable(double tolerance) { return std::clamp(tolerance, finest_tolerance, coarsest_tolerance); }

// The first table without the property, or nullptr.
template <typename Property>
const WeightTable* first_without(const WeightTables& tables, Property has) {
  for (const auto& of_sum : tables) {
    const auto found = std::ranges::find_if_not(of_sum, has);
    if (found != of_sum.end()) return &*found;
  }
  return nullptr;
}

void refuse(const WeightTable* table, std::string_view lack) {
  if (table == nullptr) return;
  throw std::invalid_argument(fmt::format("the weights of {} have no {}", table->family->id, lack));
}

}  // namespace

int StepPlan::max_steps() const {
  if (step_count) return *step_count;
  constexpr double largest = std::numeric_limits<int>::max();
  return static_cast<int>(std::min(std::round(end / min_step), largest));
}

StepPlan step_plan(const Grid& grid) {
  return {.end = grid.end, .min_step = grid.step(1), .uniform = grid.uniform(), .step_count = grid.steps};
}

ChosenHistory choose_history(HistoryKind kind, const WeightTables& tables, const StepPlan& steps,
                             double tolerance) {
  if (kind != HistoryKind::automatic) return {kind};
  if (first_without(tables, has_exponential_sum) != nullptr) return {HistoryKind::direct};
  const auto [direct, exponentials] = history_costs(tables, steps, achievable(tolerance));
  if (direct.time_and_memory() <= exponentials.time_and_memory())
    return {HistoryKind::direct, direct.time > exponentials.time};
  return {HistoryKind::exponentials, exponentials.time > direct.time};
}

std::string_view name(HistoryKind kind) {
  switch (kind) {
    case HistoryKind::automatic:
      return "auto";
    case HistoryKind::direct:
      return "direct";
    case HistoryKind::exponentials:
      return "exponentials";
  }
  std::abort();
}

namespace {

std::unique_ptr<History> history_of_kind(HistoryKind kind, const WeightTables& tables, const StepPlan& steps,
                                         double tolerance) {
  const bool direct = kind == HistoryKind::direct;
  if (!direct) refuse(first_without(tables, has_exponential_sum), "sum of exponentials");
  if (steps.uniform) {
    if (direct) return std::make_unique<DirectHistory>(tables, steps.max_steps());
    return std::make_unique<ExponentialHistory>(tables, steps.max_steps(), achievable(tolerance));
  }
  refuse(first_without(tables,
                       [](const WeightTable& table) { return table.family->endpoint_values != nullptr; }),
         "form for steps that differ");
  if (direct) return std::make_unique<VariableStepDirectHistory>(tables, steps);
  return std::make_unique<VariableStepExponentialHistory>(tables, steps, achievable(tolerance));
}

}  // namespace

std::unique_ptr<History> make_history(HistoryKind kind, const WeightTables& tables, const StepPlan& steps,
                                      double tolerance) {
  const ChosenHistory chosen = choose_history(kind, tables, steps, tolerance);
  auto history = history_of_kind(chosen.kind, tables, steps, tolerance);
  history->set_chosen(chosen);
  return history;
}

}  // namespace fde
