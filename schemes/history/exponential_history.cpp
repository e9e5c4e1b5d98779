// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/exponential_history.hpp"

#include <algorithm>

#include "fdebench/schemes/problem/smoothness.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {
namespace {

// The index of a value in a list, to which it is appended where it is new.
template <typename Value>
Eigen::Index index_in(std::vector<Value>& list, const Value& value) {
  const auto found = std::ranges::find(list, value);
  const Eigen::Index index = found - list.begin();
  if (found == list.end()) list.push_back(value);
  return index;
}

}  // namespace

Eigen::Index ExponentialHistory::Columns::of(Eigen::Index component) {
  const auto index = static_cast<std::size_t>(component);
  if (index >= columns_.size()) columns_.resize(index + 1, -1);
  if (columns_[index] < 0) {
    columns_[index] = std::ssize(components_);
    components_.push_back(component);
  }
  return columns_[index];
}

bool ExponentialHistory::Columns::are_all(Eigen::Index size) const {
  if (std::ssize(components_) != size) return false;
  for (std::size_t i = 0; i < components_.size(); ++i)
    if (components_[i] != static_cast<Eigen::Index>(i)) return false;
  return true;
}

ExponentialHistory::ExponentialHistory(const WeightTables& tables, int steps, double tolerance)
    : size_(std::ssize(tables.front())) {
  for (const auto& of_sum : tables) {
    auto& sum = sums_.emplace_back();
    for (std::size_t i = 0; i < of_sum.size(); ++i) add(sum, of_sum[i], static_cast<Eigen::Index>(i));
  }
  for (auto& group : groups_) {
    const auto columns = std::ssize(group.columns.components());
    memories_.emplace_back(group.tables, columns, steps, tolerance);
  }
  for (auto& filter : filters_) {
    const auto columns = std::ssize(filter.columns.components());
    if (columns < ExponentialMemory::fewest_wide) {
      filtered_.emplace_back(FilteredMemory(filter.table, columns, steps, tolerance));
    } else {
      filtered_.emplace_back(WideFilteredMemory(filter.table, columns, steps, tolerance));
    }
  }
  if (needs_totals_) totals_ = RunningSums(size_);
  drop_identity_lists();
}

// Lists of columns are as large as a sample; they are dropped where they are the identity.
void ExponentialHistory::drop_identity_lists() {
  const auto drop_list = [&](TableUse& use, const Columns& columns) {
    use.all = std::ssize(use.components) == size_ && columns.are_all(size_);
    if (use.all) use.components = {};
  };
  for (auto& sum : sums_) {
    for (auto& use : sum.uses) drop_list(use, groups_[use.group].columns);
    for (auto& use : sum.filtered) drop_list(use, filters_[use.group].columns);
    sum.is_one_table = sum.constants.empty() && sum.filtered.empty() && sum.uses.size() == 1 &&
                       sum.uses.front().all && !sum.uses.front().alternates;
  }
  const auto drop_columns = [&](auto& part, bool unchanged) {
    part.all = unchanged && part.columns.are_all(size_);
    if (part.all) {
      part.columns = {};
    } else {
      part.sample.resize(std::ssize(part.columns.components()));
    }
  };
  for (auto& group : groups_) drop_columns(group, !group.running_sums && !group.alternates);
  for (auto& filter : filters_) drop_columns(filter, true);
}

void ExponentialHistory::add(Sum& sum, const WeightTable& table, Eigen::Index component) {
  const auto& family = *table.family;
  if (const auto constant = constant_weight(table)) {
    needs_totals_ = true;
    sum.constants.push_back({component, first_sample_weight(table, 1).value_or(*constant), *constant});
    return;
  }
  if (family.filter != nullptr) return add_filtered(sum, table, component);
  if (family.smooth_part == nullptr) return add_exponentials(sum, table, component, false);
  add_exponentials(sum, {family.smooth_part, table.order}, component, false);
  if (!is_integer_order(table.order))
    add_exponentials(sum, {family.alternating_part, table.order}, component, true);
}

void ExponentialHistory::add_filtered(Sum& sum, const WeightTable& table, Eigen::Index component) {
  auto found = std::ranges::find(filters_, table, &Filtered::table);
  if (found == filters_.end()) found = filters_.insert(found, {table});
  const auto filter = static_cast<std::size_t>(found - filters_.begin());
  auto use = std::ranges::find(sum.filtered, filter, &TableUse::group);
  if (use == sum.filtered.end()) use = sum.filtered.insert(use, {filter, 0, false});
  use->components.emplace_back(component, found->columns.of(component));
}

void ExponentialHistory::add_exponentials(Sum& sum, const WeightTable& table, Eigen::Index component,
                                          bool alternates) {
  const long double exponent = kernel_exponent(table);
  const bool running_sums = acts_on_running_sums(table);
  needs_totals_ = needs_totals_ || running_sums;
  auto found = std::ranges::find_if(groups_, [&](const auto& group) {
    return group.exponent == exponent && group.running_sums == running_sums && group.alternates == alternates;
  });
  if (found == groups_.end()) found = groups_.insert(found, {exponent, running_sums, alternates});
  const auto group = static_cast<std::size_t>(found - groups_.begin());
  const auto row = index_in(found->tables, table);
  auto use = std::ranges::find_if(
      sum.uses, [&](const auto& other) { return other.group == group && other.table == row; });
  if (use == sum.uses.end()) use = sum.uses.insert(use, {group, row, alternates});
  use->components.emplace_back(component, found->columns.of(component));
}

void ExponentialHistory::push(double /*t*/, In sample) {
  auto filtered = filtered_.begin();
  for (auto& filter : filters_) {
    for (Eigen::Index c = 0; c < filter.sample.size(); ++c)
      filter.sample[c] = sample[filter.columns.components()[static_cast<std::size_t>(c)]];
    std::visit(
        [&](auto& memory) {
          if (filter.all) return memory.push(sample);
          memory.push(filter.sample);
        },
        *filtered++);
  }
  sign_ = -sign_;
  if (first_.size() == 0) return begin(sample);
  if (needs_totals_) totals_.add(sample);
  auto memory = memories_.begin();
  for (auto& group : groups_) {
    if (group.all) {
      (memory++)->push(sample);
      continue;
    }
    for (Eigen::Index c = 0; c < group.sample.size(); ++c) {
      const auto i = group.columns.components()[static_cast<std::size_t>(c)];
      group.sample[c] = group.running_sums ? totals_[i] : group.alternates ? -sign_ * sample[i] : sample[i];
    }
    (memory++)->push(group.sample);
  }
}

void ExponentialHistory::begin(In sample) {
  first_ = sample;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    auto& group = groups_[g];
    if (group.all) {
      memories_[g].begin(sample);
      continue;
    }
    for (Eigen::Index c = 0; c < group.sample.size(); ++c)
      group.sample[c] = sample[group.columns.components()[static_cast<std::size_t>(c)]];
    memories_[g].begin(group.sample);
  }
}

void ExponentialHistory::convolve(double /*t*/, std::size_t sum, Out result) const {
  const Sum& of = sums_.begin()[static_cast<std::ptrdiff_t>(sum)];
  const auto first = of.uses.begin();
  if (of.is_one_table) {
    memories_.begin()[static_cast<std::ptrdiff_t>(first->group)].convolve(first->table, result.data());
    return;
  }
  for (const auto& [i, start, constant] : of.constants) {
    result[i] = start * first_[i] + constant * totals_[i];
  }
  for (const auto& use : of.filtered) {
    std::visit(
        [&](const auto& memory) {
          if (use.all) for_each_component(size_, [&](Eigen::Index i) { result[i] = memory.convolved(i); });
          for (const auto& [i, column] : use.components) result[i] = memory.convolved(column);
        },
        filtered_[use.group]);
  }
  for (const auto& use : of.uses) {
    const ExponentialMemory& memory = memories_[use.group];
    if (use.all && !use.alternates) {
      memory.convolve(use.table, result.data());
      continue;
    }
    const auto convolved = memory.convolved(use.table);
    const double* const values = convolved.data();
    const Eigen::Index stride = convolved.innerStride();
    if (use.alternates) {
      if (use.all)
        for_each_component(size_, [&](Eigen::Index i) { result[i] += sign_ * values[i * stride]; });
      for (const auto& [i, column] : use.components) result[i] += sign_ * values[column * stride];
    } else {
      for (const auto& [i, column] : use.components) result[i] = values[column * stride];
    }
  }
}

std::size_t ExponentialHistory::bytes() const {
  std::size_t bytes = sizeof(double) * static_cast<std::size_t>(size_ + 2 * totals_.size());
  for (const auto& memory : memories_) bytes += memory.bytes();
  for (const auto& memory : filtered_)
    bytes += std::visit([](const auto& one) { return one.bytes(); }, memory);
  return bytes;
}

void ExponentialHistory::state(Archive& archive) {
  archive.resizable(first_);
  archive(sign_, totals_, memories_);
  for (auto& memory : filtered_) std::visit([&](auto& one) { archive(one); }, memory);
}

}  // namespace fde
