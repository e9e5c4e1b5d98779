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

NarrowMemory::NarrowMemory(const MemoryTables& tables, Eigen::Index components)
    : first_(Vec::Zero(components)),
      samples_(Matrix::Zero(recent + block, components)),
      gathered_(Matrix::Zero(tables.gather.rows(), components)),
      states_(Matrix::Zero(tables.nodes.size(), components)),
      carries_(states_),
      input_(Matrix::Zero(tables.slow, components)),
      condensed_(Matrix::Zero(tables.points(), components)),
      weighted_(Matrix::Zero(tables.far.cols(), tables.count * components)),
      sums_(Matrix::Zero(tables.count * block, components)) {}

void NarrowMemory::begin(In first, const FirstSampleWeights& start) {
  first_ = first;
  add_exact(start);
}

// Adds x_0 times its exact weights to the sums of a block.
void NarrowMemory::add_exact(const FirstSampleWeights& start) {
  multiply_add(sums_.rows(), 1, sums_.cols(), start.exact(), {first_.data(), 1}, sums_);
}

void NarrowMemory::push(const MemoryTables& tables, Eigen::Index position, In sample,
                        const FirstSampleWeights& start) {
  for_each_component(samples_.cols(), [to = samples_.data() + recent + position, stride = samples_.rows(),
                                       x = sample.data()](Eigen::Index c) { to[c * stride] = x[c]; });
  const Eigen::Index column = position % recent, first = position - column;
  if (column + 1 < recent) {
    add_outer_product(tables.count, tables.inner.data() + column * tables.inner.rows(), sample.data(),
                      sums_.cols(), block, {sums_.data() + first, sums_.rows()});
  }
  if (column + 1 == recent) end_group(tables, position + 1, start);
}

void NarrowMemory::end_group(const MemoryTables& tables, Eigen::Index next, const FirstSampleWeights& start) {
  if (next == block) {
    advance_block(tables, start);
  } else {
    add_recent(tables, next);
  }
}

// Adds the newest `recent` samples, with exact weights, to the sums of the rest of the block.
void NarrowMemory::add_recent(const MemoryTables& tables, Eigen::Index position) {
  for (Eigen::Index table = 0; table < tables.count; ++table) {
    multiply_add(block - position, recent, sums_.cols(), {&tables.near(table * block, 0), tables.near.rows()},
                 {&samples_(position, 0), samples_.rows()},
                 {&sums_(table * block + position, 0), sums_.rows()});
  }
}

void NarrowMemory::advance_block(const MemoryTables& tables, const FirstSampleWeights& start) {
  const Eigen::Index columns = sums_.cols(), points = tables.points(), slow = tables.slow;
  const Eigen::Index others = states_.rows() - slow;
  const auto below = [](Matrix& whole, Eigen::Index row) { return Block(whole.data() + row, whole.rows()); };
  gathered_.setZero();
  multiply_add(gathered_.rows(), block, columns, tables.gather, samples_, gathered_);
  input_.setZero();
  multiply_add(slow, points, columns, tables.spread, gathered_, input_);
  advance_states(slow, columns, tables.decay_minus_one.data(), input_, states_, carries_);
  advance_states(others, columns, tables.decay_minus_one.data() + slow, below(gathered_, points),
                 below(states_, slow), below(carries_, slow));
  samples_.topRows(recent) = samples_.bottomRows(recent);
  condensed_.setZero();
  multiply_add(points, slow, columns, tables.condense, states_, condensed_);
  for (Eigen::Index c = 0; c < columns; ++c) {
    for (Eigen::Index table = 0; table < tables.count; ++table) {
      const double* const factors = &tables.factors(0, table);
      const double* const of_first = &start.weighted()(0, table);
      double* const result = &weighted_(0, c * tables.count + table);
      weighted_sum(points, factors, condensed_.data() + c * points, first_[c], of_first, result);
      weighted_sum(others, factors + points, &states_(slow, c), first_[c], of_first + points,
                   result + points);
    }
  }
  sums_.setZero();
  multiply_add(block, weighted_.rows(), weighted_.cols(), tables.far, weighted_, {sums_.data(), block});
  if (start.has_exact_after_first_block()) add_exact(start);
  add_recent(tables, 0);
}

std::size_t NarrowMemory::bytes() const {
  const auto doubles = samples_.size() + gathered_.size() + 2 * states_.size() + input_.size() +
                       condensed_.size() + weighted_.size() + sums_.size() + first_.size();
  return sizeof(double) * static_cast<std::size_t>(doubles);
}

}  // namespace fde
