// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/exponential_memory.hpp"

namespace fde {
namespace {

std::variant<NarrowMemory, WideMemory> past_of(const MemoryTables& tables, Eigen::Index components) {
  if (components < ExponentialMemory::fewest_wide) return NarrowMemory(tables, components);
  return WideMemory(tables, components);
}

ExponentialSum sum_for(const WeightTable& table, int steps, double tolerance) {
  if (!ExponentialMemory::needs_exponentials(steps)) return {Vec(0), Vec(0), 0.0};
  return exponential_sum(kernel_exponent(table), ExponentialMemory::shortest_lag, steps + 2.0, tolerance);
}

}  // namespace

ExponentialMemory::ExponentialMemory(const std::vector<WeightTable>& tables, Eigen::Index components,
                                     int steps, double tolerance)
    : tables_(tables, sum_for(tables.front(), steps, tolerance), steps),
      start_(tables, tables_),
      memory_(past_of(tables_, components)) {}

void ExponentialMemory::begin(In first) {
  std::visit([&](auto& memory) { memory.begin(first, start_); }, memory_);
}

void ExponentialMemory::push(In sample) {
  const Eigen::Index next = (position_ + 1) % block;
  if (next == 0) start_.advance_block(tables_);
  std::visit([&](auto& memory) { memory.push(tables_, position_, sample, start_); }, memory_);
  position_ = next;
}

std::size_t ExponentialMemory::bytes() const {
  const auto doubles = tables_.nodes.size() + tables_.decay_minus_one.size() + tables_.gather.size() +
                       tables_.spread.size() + tables_.condense.size() + tables_.inner.size() +
                       tables_.near.size() + tables_.factors.size() + tables_.far.size() +
                       2 * tables_.compressed.nodes.size();
  const auto of_memory = std::visit([](const auto& memory) { return memory.bytes(); }, memory_);
  return sizeof(double) * static_cast<std::size_t>(doubles) + start_.bytes() + of_memory;
}

void ExponentialMemory::state(Archive& archive) {
  archive.count(position_, 0, block - 1);
  archive(start_);
  std::visit([&](auto& memory) { archive(memory); }, memory_);
}

}  // namespace fde
