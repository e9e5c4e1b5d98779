// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/history_costs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "fdebench/schemes/history/exponential_memory.hpp"
#include "fdebench/schemes/history/filtered_memory.hpp"
#include "fdebench/schemes/history/weights/exponential_sum.hpp"
#include "fdebench/schemes/history/weights/kernel_moments.hpp"

namespace fde {
namespace {

constexpr double block = MemoryTables::block, recent = MemoryTables::recent;

// ns, measured with AVX-512 on an EPYC (Zen 5) by fde_histories --benchmark_filter=choice.
constexpr double weight_by_formula = 440.0, weight_by_recurrence = 20.0, filter_coefficient = 55.0;
constexpr double sum_of_exponentials = 11'500.0, node_of_sum = 430.0, node_of_step = 2.3;
constexpr double interval_weight = 55.0, step_factor_of_table = 190.0;  // of variable steps

// The distinct tables of a run, except those that is_free, with the number of their uses, over all sums and
// components.
template <class Predicate>
std::vector<std::pair<WeightTable, double>> counted(const WeightTables& tables, Predicate is_free) {
  std::vector<std::pair<WeightTable, double>> uses;
  for (const auto& of_sum : tables) {
    for (const auto& table : of_sum) {
      if (is_free(table)) continue;
      auto found = std::ranges::find(uses, table, [](const auto& use) { return use.first; });
      if (found == uses.end()) found = uses.insert(found, {table, 0.0});
      ++found->second;
    }
  }
  return uses;
}

// With equal steps constant weights are a running sum.
bool has_constant_weight(const WeightTable& table) { return constant_weight(table).has_value(); }

// The number of exponentials of a kernel for times whose ratio is at most this.
double exponential_count(double ratio, double tolerance) {
  const double digits = std::log(3.0 / tolerance), h = std::numbers::pi * std::numbers::pi / (digits + 5.5);
  return 0.47 * (digits + 1.0) + std::log(ratio) / h;
}

// The exponents of the kernels whose exponentials a table uses, and whether they weigh running sums: those of
// Grunwald-Letnikov for weights with a filter, two for weights in two parts.
std::vector<WeightTable> parts_of(const WeightTable& table) {
  const auto& family = *table.family;
  if (family.filter != nullptr) return {{&families::grunwald_letnikov, table.order}};
  if (family.smooth_part == nullptr) return {table};
  return {{family.smooth_part, table.order}, {family.alternating_part, table.order}};
}

// The first touch of an array of so many doubles. Smaller arrays are in memory that the process has used
// before; the C library returns larger ones to the system.
double first_touch(double doubles) {
  constexpr double largest_kept = 0x1p25, touched_byte = 0.4;
  const double bytes = sizeof(double) * doubles;
  return bytes > largest_kept ? bytes * touched_byte : 0.0;
}

// An array of so many doubles: its memory, and the time of its first touch.
HistoryCost array_cost(double doubles) { return {first_touch(doubles), sizeof(double) * doubles}; }

HistoryCost& operator+=(HistoryCost& sum, const HistoryCost& more) {
  sum.time += more.time;
  sum.bytes += more.bytes;
  return sum;
}

double weight_cost(const WeightTable& table) {
  return table.family->first_weights != nullptr ? weight_by_recurrence : weight_by_formula;
}

// Of a weight of x_0, where it is not 0.
double start_cost(const WeightTable& table) {
  const auto& family = *table.family;
  const bool zero = family.first_sample_weight != nullptr && family.first_sample_coefficient == nullptr;
  return zero ? 0.0 : weight_by_formula;
}

// A WideFilteredMemory of a table used so often.
HistoryCost wide_filter_cost(const WeightTable& table, double uses, double steps, double tolerance) {
  const double longest = steps + 2.0;
  const auto lags = static_cast<double>(WideFilteredMemory::exact_lags(*table.family->multistep, longest));
  const double nodes = lags < longest ? exponential_count(longest / lags, tolerance) : 0.0;
  const double blocks = std::floor(steps / block), multiply_adds = lags + 2.0 * nodes + recent + block / 2;
  HistoryCost cost = array_cost(uses * (lags + block));
  for (int array = 0; array < 2; ++array) cost += array_cost(uses * nodes);  // states and carries
  cost.time += (lags + block) * (weight_by_recurrence + 10.0) + nodes * node_of_sum +
               (nodes > 0.0 ? sum_of_exponentials : 0.0) + steps * 60.0 +
               uses * (blocks * block * multiply_adds / 60.0 + steps);
  return cost;
}

// The weights and starts of an ExponentialMemory; those of two parts follow from recurrences.
double exact_weights_cost(const WeightTable& whole, const WeightTable& part, double steps) {
  constexpr double by_recurrences = 75.0;
  const double longest = std::min(steps, block + recent - 1), starts = std::min(steps, block);
  if (whole != part && whole.family->filter == nullptr) return by_recurrences * longest;
  if (!acts_on_running_sums(part)) return weight_cost(part) * longest + start_cost(part) * starts;
  return 2.0 * (weight_by_formula * longest + start_cost(part) * starts);
}

// A multiply-add of a dot product with samples that are read once a step: from the first to the second cache,
// and beyond.
double multiply_add_cost(double bytes) {
  if (bytes > 1.2e7) return 0.4;
  if (bytes > 1.5e6) return 0.17;
  return 0.06 + 0.035 * std::clamp(std::log2(bytes / 0x1p14) / 3.0, 0.0, 1.0);
}

// Every step is a dot product with all samples before it.
HistoryCost direct_cost(const WeightTables& tables, double steps) {
  const auto components = static_cast<double>(tables.front().size());
  const double each = multiply_add_cost(sizeof(double) * components * steps);
  HistoryCost cost = array_cost(steps * components);
  cost.time += 800.0 + 10.0 * components + steps * (8.0 + components);
  cost.bytes += 3 * sizeof(double) * components;  // running sums and x_0
  for (const auto& [table, uses] : counted(tables, has_constant_weight)) {
    const bool own_start = table.family->first_sample_coefficient != nullptr;
    cost.time += steps * (weight_cost(table) + (own_start ? start_cost(table) : 0.0));
    cost.time += uses * steps * (6.0 + each * steps / 2);
    cost.bytes += 2 * sizeof(double) * steps;
  }
  return cost;
}

// The multiply-adds of docs/history.md, section 3.
HistoryCost exponentials_cost(const WeightTables& tables, double steps, double tolerance) {
  const auto components = static_cast<double>(tables.front().size());
  const bool wide = components >= ExponentialMemory::fewest_wide;
  const bool needs_exponentials = ExponentialMemory::needs_exponentials(static_cast<Eigen::Index>(steps));
  const double nodes = needs_exponentials ? exponential_count(steps / recent, tolerance) : 0.0;
  const double blocks = std::floor((steps - 1.0) / block);
  HistoryCost cost{1250.0 + 25.0 * components, sizeof(double) * components};
  std::vector<std::tuple<long double, bool, bool>> kernels;
  for (const auto& [whole, uses] : counted(tables, has_constant_weight)) {
    if (whole.family->smooth_part != nullptr)
      cost.time += uses * (25.0 + steps * (components < 5e3 ? 3.0 : 20.0));
    if (whole.family->filter != nullptr && wide) {
      cost += wide_filter_cost(whole, uses, steps, tolerance);
      continue;
    }
    if (whole.family->filter != nullptr) {
      const auto length = static_cast<double>(whole.family->filter(whole.order).size());
      cost.time += length * filter_coefficient + uses * steps * (10.0 + 0.05 * length);
    }
    for (const auto& table : parts_of(whole)) {
      cost.time += exact_weights_cost(whole, table, steps);
      const std::tuple kernel{kernel_exponent(table), acts_on_running_sums(table),
                              table.family == whole.family->alternating_part};
      double multiply_adds = nodes + recent + block / 2;
      cost += array_cost(uses * block);
      if (std::ranges::find(kernels, kernel) == kernels.end()) {
        kernels.push_back(kernel);
        if (needs_exponentials) cost.time += sum_of_exponentials + nodes * node_of_sum;
        cost += array_cost(components * (recent + block));
        for (int array = 0; array < 2; ++array) cost += array_cost(components * nodes);
        cost.bytes += 2 * sizeof(double) * components;  // x_0 and the present sums
        multiply_adds += nodes;
      }
      cost.time += uses * (blocks * block * multiply_adds / 60.0 + steps * (wide ? 0.9 : 2.0)) +
                   steps * (wide ? 60.0 : 12.0);
    }
  }
  return cost;
}

// With variable steps a weight costs a power, and an exponential new factors in each step.
HistoryCosts variable_step_costs(const WeightTables& tables, const StepPlan& plan, double tolerance) {
  const double steps = plan.max_steps(), pairs_of_steps = steps * steps / 2;
  const double most_nodes = exponential_count(2.0 * plan.end / plan.min_step, tolerance);
  const auto has_no_memory = [](const WeightTable& table) { return integral_order(table) == 0.0; };
  const auto components = static_cast<double>(tables.front().size());
  HistoryCost direct{500.0, sizeof(double) * steps * components},
      exponentials{500.0, sizeof(double) * components};
  std::vector<double> orders;
  std::vector<long double> exponents;
  for (const auto& [table, uses] : counted(tables, has_no_memory)) {
    const double nodes = kernel_exponent(table) == 1.0L ? 1.0 : most_nodes;  // a constant kernel
    if (std::ranges::find(orders, integral_order(table)) == orders.end()) {
      orders.push_back(integral_order(table));
      const double powers = acts_on_running_sums(table) ? 1.6 : 1.0;  // running integrals have further powers
      direct.time += powers * pairs_of_steps * interval_weight + steps * 130.0;
      direct.bytes += 2 * sizeof(double) * steps;
    }
    direct.time += step_factor_of_table * steps + uses * (steps * 2.0 + pairs_of_steps * 2.1);
    if (std::ranges::find(exponents, kernel_exponent(table)) == exponents.end()) {
      exponents.push_back(kernel_exponent(table));
      exponentials.time +=
          (nodes > 1.0 ? sum_of_exponentials : 0.0) + nodes * 100.0 + steps * nodes * node_of_step;
      exponentials.bytes += sizeof(double) * components * (2.0 * nodes + 3.0);  // and a polynomial
    }
    exponentials.time += uses * (150.0 + steps * nodes * 0.4);
  }
  return {direct, exponentials};
}

}  // namespace

double HistoryCost::time_and_memory() const {
  constexpr double small = 0x1p28;
  return time * std::max(bytes, small);
}

HistoryCosts history_costs(const WeightTables& tables, const StepPlan& steps, double tolerance) {
  if (!steps.uniform) return variable_step_costs(tables, steps, tolerance);
  return {direct_cost(tables, steps.max_steps()), exponentials_cost(tables, steps.max_steps(), tolerance)};
}

}  // namespace fde
