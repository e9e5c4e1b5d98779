#include "history/wide_past.hpp"

#include <algorithm>

#include "history/shared_work.hpp"

namespace fde {
namespace {

Eigen::Index to_multiple(Eigen::Index count, Eigen::Index of) { return (count + of - 1) / of * of; }

}  // namespace

WidePast::WidePast(const MemoryTables& tables, Eigen::Index components, int threads)
    : components_(components),
      threads_(threads),
      gather_(tables.gather.topRows(tables.exponentials).transpose()),
      inner_(tables.inner.transpose()),
      near_(tables.near.transpose()),
      far_(tables.far.leftCols(tables.exponentials).transpose()) {
  const Eigen::Index rows = to_multiple(components, lanes), tiles = to_multiple(rows, tile) / tile;
  samples_.setZero(rows, recent + block);
  sums_.setZero(rows, tables.count * block);
  current_.setZero(rows, tables.count);
  states_.setZero(tile * tables.exponentials, tiles);
  carries_ = states_;
}

void WidePast::push(const MemoryTables& tables, Eigen::Index position, In sample) {
  share_work(threads_, current_.rows(), tile, [&](Eigen::Index first, Eigen::Index count) {
    push_part(tables, position, sample, first, count);
  });
}

void WidePast::push_part(const MemoryTables& tables, Eigen::Index position, In sample, Eigen::Index first,
                         Eigen::Index count) {
  const Eigen::Index real = std::min(count, components_ - first);
  samples_.col(recent + position).segment(first, real) = sample.segment(first, real);
  const Eigen::Index next = (position + 1) % block;
  if (next == 0) {
    Matrix input(tile, far_.rows());
    for (Eigen::Index done = 0; done < count; done += tile)
      advance_tile(tables, first + done, std::min(tile, count - done), input);
  } else if (next % recent == 0) {
    for (Eigen::Index done = 0; done < count; done += tile)
      pass_on(next, first + done, std::min(tile, count - done), tables.count);
  }
  take_sums(next, first, count, tables.count);
}

// What the newest `recent` samples add to the rest of the block.
void WidePast::pass_on(Eigen::Index position, Eigen::Index first, Eigen::Index count, Eigen::Index tables) {
  for (Eigen::Index table = 0; table < tables; ++table) {
    multiply_add(count, recent, block - position, {&samples_(first, position), samples_.rows()},
                 {&near_(0, table * block), recent}, {&sums_(first, table * block + position), sums_.rows()});
  }
}

void WidePast::advance_tile(const MemoryTables& tables, Eigen::Index first, Eigen::Index count,
                            Matrix& input) {
  const Eigen::Index exponentials = far_.rows();
  const Block states(states_.col(first / tile).data(), tile),
      carries(carries_.col(first / tile).data(), tile);
  input.setZero();
  multiply_add(count, block, exponentials, {&samples_(first, 0), samples_.rows()}, gather_, input);
  advance_columns(count, exponentials, tables.decay_minus_one.data(), input, states, carries);
  auto samples = samples_.middleRows(first, count);
  samples.leftCols(recent) = samples.rightCols(recent);
  sums_.middleRows(first, count).setZero();
  multiply_add(count, exponentials, far_.cols(), {states.data, tile}, far_, {&sums_(first, 0), sums_.rows()});
  pass_on(0, first, count, tables.count);
}

// To the sums of a step its own group of samples is added, in their order.
void WidePast::take_sums(Eigen::Index position, Eigen::Index first, Eigen::Index count, Eigen::Index tables) {
  const Eigen::Index newest = position % recent, oldest = position - newest;
  for (Eigen::Index table = 0; table < tables; ++table) {
    current_.col(table).segment(first, count) = sums_.col(table * block + position).segment(first, count);
    multiply_add(count, newest, 1, {&samples_(first, recent + oldest), samples_.rows()},
                 {&inner_(0, table * recent + newest), recent}, {&current_(first, table), current_.rows()});
  }
}

std::size_t WidePast::bytes() const {
  const auto of_components = samples_.size() + sums_.size() + current_.size() + 2 * states_.size();
  const auto of_tables = gather_.size() + inner_.size() + near_.size() + far_.size();
  return sizeof(double) * static_cast<std::size_t>(of_components + of_tables);
}

}  // namespace fde
