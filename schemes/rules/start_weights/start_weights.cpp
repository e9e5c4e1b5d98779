// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/start_weights/start_weights.hpp"

#include <map>
#include <mutex>
#include <optional>
#include <tuple>
#include <utility>

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

}  // namespace fde
