#include "history/narrow_past.hpp"

namespace fde {

NarrowPast::NarrowPast(const MemoryTables& tables, Eigen::Index components)
    : samples_(Matrix::Zero(recent + block, components)),
      states_(Matrix::Zero(tables.nodes.size(), components)),
      carries_(states_),
      input_(states_),
      sums_(Matrix::Zero(tables.count * block, components)) {}

void NarrowPast::push(const MemoryTables& tables, Eigen::Index position, In sample) {
  samples_.row(recent + position) = sample;
  const Eigen::Index column = position % recent, first = position - column;
  for (Eigen::Index table = 0; table < tables.count; ++table) {
    scatter(&tables.inner(table * recent, column), sample.data(), sums_.cols(),
            {&sums_(table * block + first, 0), sums_.rows()});
  }
  if (position + 1 == block) {
    advance_block(tables);
  } else if ((position + 1) % recent == 0) {
    pass_on(tables, position + 1);
  }
}

// What the newest `recent` samples add to the rest of the block.
void NarrowPast::pass_on(const MemoryTables& tables, Eigen::Index position) {
  for (Eigen::Index table = 0; table < tables.count; ++table) {
    multiply_add(block - position, recent, sums_.cols(), {&tables.near(table * block, 0), tables.near.rows()},
                 {&samples_(position, 0), samples_.rows()},
                 {&sums_(table * block + position, 0), sums_.rows()});
  }
}

void NarrowPast::advance_block(const MemoryTables& tables) {
  input_.setZero();
  multiply_add(states_.rows(), block, input_.cols(), tables.gather, samples_, input_);
  advance(states_.rows(), states_.cols(), tables.decay_minus_one.data(), input_, states_, carries_);
  samples_.topRows(recent) = samples_.bottomRows(recent);
  sums_.setZero();
  multiply_add(tables.far.rows(), tables.far.cols(), sums_.cols(), tables.far, states_, sums_);
  pass_on(tables, 0);
}

std::size_t NarrowPast::bytes() const {
  return sizeof(double) * static_cast<std::size_t>(samples_.size() + 3 * states_.size() + sums_.size());
}

}  // namespace fde
