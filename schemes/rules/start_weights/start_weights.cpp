// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/start_weights/start_weights.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "fdebench/schemes/problem/smoothness.hpp"
#include "fdebench/schemes/rules/start_weights/starting_weight_equations.hpp"
#include "fdebench/schemes/stepping/setup_time.hpp"

namespace fde {

namespace {

// The number of pieces for n up to `steps`.
std::size_t pieces_for(int steps, Eigen::Index near) {
  std::size_t count = 0;
  for (auto end = static_cast<double>(near); end < steps; end *= 2.0) ++count;
  return count;
}

using Key = std::tuple<const WeightFamily*, double, std::vector<double>>;

// A cache for runs with the same orders. It is cleared when it is full, as in a search over many orders.
template <class Value>
class Cache {
 public:
  std::optional<Value> get(const Key& key) {
    const std::lock_guard lock(mutex_);
    const auto found = values_.find(key);
    return found == values_.end() ? std::nullopt : std::optional(found->second);
  }
  void put(const Key& key, Value value) {
    constexpr std::size_t most = 1024;  // 0.3 MB each; a sweep over all scenes needs hundreds
    const std::lock_guard lock(mutex_);
    if (values_.size() >= most) values_.clear();
    values_.insert_or_assign(key, std::move(value));
  }

 private:
  std::mutex mutex_;
  std::map<Key, Value> values_;
};

// More powers are never usable: the growth for 24 powers is at least 1e9.
constexpr std::size_t most_powers = 24;

}  // namespace

std::shared_ptr<const StartingWeights> starting_weights(const WeightTable& table,
                                                        const std::vector<double>& powers, int steps) {
  static Cache<std::shared_ptr<const StartingWeights>> kept;
  const Key key{table.family, table.order, powers};
  const auto known = kept.get(key);
  if (known && (*known)->pieces.size() >= pieces_for(steps, (*known)->tabulated.rows())) {
    count_table(known->get(), (*known)->seconds);
    return *known;
  }
  const double start = thread_seconds();
  auto made = std::make_shared<StartingWeights>();
  if (known) {
    *made = **known;
  } else {
    made->equations = starting_weight_equations(table, powers);
    made->tabulated = made->equations->tabulated_weights();
  }
  while (made->pieces.size() < pieces_for(steps, made->tabulated.rows()))
    made->pieces.push_back(made->equations->asymptotic_weights(made->pieces.size()));
  made->seconds += thread_seconds() - start;
  count_table(made.get(), made->seconds);
  kept.put(key, made);
  return made;
}

std::size_t StartingWeights::bytes(int steps) const {
  auto doubles = tabulated.size();
  for (const auto& piece : std::span(pieces).first(pieces_for(steps, tabulated.rows())))
    doubles += piece.smooth.size() + piece.alternating.size() + piece.decaying.size();
  return sizeof(double) * static_cast<std::size_t>(doubles);
}

UsablePowers usable_powers(const WeightTable& table, const std::vector<double>& powers) {
  static Cache<std::shared_ptr<const std::pair<UsablePowers, double>>> kept;  // with its seconds
  const Key key{table.family, table.order, powers};
  auto known = kept.get(key);
  if (!known) {
    const double start = thread_seconds();
    const auto usable = count_usable(table, powers, max_growth);
    known = std::make_shared<const std::pair<UsablePowers, double>>(usable, thread_seconds() - start);
    kept.put(key, *known);
  }
  count_table(known->get(), (*known)->second);
  return (*known)->first;
}

std::vector<double> StartingPowers::for_steps(int steps) const {
  const auto count = std::min(std::ssize(powers), std::ptrdiff_t{steps} + 1);
  return {powers.begin(), powers.begin() + count};
}

StartingPowers starting_powers(const WeightFamily& family, const Problem& problem) {
  std::vector<double> orders;
  for (const auto& component : problem.components) {
    if (!is_algebraic(component)) orders.push_back(component.order);
  }
  return starting_powers(family, orders, orders);
}

StartingPowers starting_powers(const WeightFamily& family, std::vector<double> orders,
                               std::vector<double> steps) {
  orders = increasing(std::move(orders));
  steps.push_back(1.0);
  const double last = family.multistep->rate - 1.0;
  // Multiples of the smallest step that makes another power are as many powers as are needed.
  double smallest = 1.0;
  for (const double step : steps)
    if (step > power_separation) smallest = std::min(smallest, step);
  const double enough = (most_powers + 1.0) * (smallest + 2.0 * power_separation);
  const auto sums = power_lattice({0.0}, steps, std::min(last + 2.0, enough));
  StartingPowers start{{}, 0.0, 0.0};
  for (const double power : sums) {
    if (power <= last + power_separation && start.powers.size() < most_powers) start.powers.push_back(power);
  }
  for (const double order : orders) {
    const auto usable = usable_powers({&family, order}, start.powers);
    start.powers.resize(usable.count);
  }
  for (const double order : orders)
    start.growth = std::max(start.growth, usable_powers({&family, order}, start.powers).growth);
  start.next = sums[start.powers.size()];
  return start;
}

}  // namespace fde
