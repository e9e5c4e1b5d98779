// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/wide_memory.hpp"

#include <algorithm>

#include "fdebench/schemes/history/parallel_for_rows.hpp"

namespace fde {
namespace {

Eigen::Index to_multiple(Eigen::Index count, Eigen::Index of) { return (count + of - 1) / of * of; }

}  // namespace

WideMemory::WideMemory(const MemoryTables& tables, Eigen::Index components, int threads)
    : components_(components),
      threads_(threads),
      inner_(tables.inner.transpose()),
      near_(tables.near.transpose()) {
  const Eigen::Index fillers = tables.nodes.size() - tables.exponentials, points = tables.points();
  const Eigen::Index slow = std::max(tables.slow - fillers, Eigen::Index{0});
  const Eigen::Index together = points + tables.exponentials - slow;
  gather_ = tables.gather.bottomRows(together).transpose();
  spread_ = tables.spread.bottomRows(slow).transpose();
  condense_ = tables.condense.rightCols(slow).transpose();
  far_ = tables.far.rightCols(together).transpose();
  const Eigen::Index rows = to_multiple(components, lanes), tiles = to_multiple(rows, tile) / tile;
  first_.setZero(rows);
  samples_.setZero(rows, recent + block);
  sums_.setZero(rows, tables.count * block);
  current_.setZero(rows, tables.count);
  states_.setZero(tile * tables.exponentials, tiles);
  carries_ = states_;
}

void WideMemory::begin(In first, const FirstSampleWeights& start) {
  first_.head(components_) = first;
  add_exact(start, 0, sums_.rows());
  complete_sums(0, 0, sums_.rows(), current_.cols());
}

// Adds x_0 times its exact weights to the sums of a block.
void WideMemory::add_exact(const FirstSampleWeights& start, Eigen::Index first, Eigen::Index count) {
  multiply_add(count, 1, sums_.cols(), {first_.data() + first, first_.size()}, {start.exact().data(), 1},
               {&sums_(first, 0), sums_.rows()});
}

void WideMemory::push(const MemoryTables& tables, Eigen::Index position, In sample,
                      const FirstSampleWeights& start) {
  parallel_for_rows(threads_, current_.rows(), tile, [&](Eigen::Index first, Eigen::Index count) {
    push_part(tables, position, sample, start, first, count);
  });
}

void WideMemory::push_part(const MemoryTables& tables, Eigen::Index position, In sample,
                           const FirstSampleWeights& start, Eigen::Index first, Eigen::Index count) {
  const Eigen::Index real = std::min(count, components_ - first);
  samples_.col(recent + position).segment(first, real) = sample.segment(first, real);
  const Eigen::Index next = (position + 1) % block;
  if (next == 0) {
    Scratch scratch{Matrix(tile, far_.rows()), Matrix(tile, spread_.cols()), Matrix(tile, spread_.rows()),
                    Matrix(tile, far_.rows())};
    for (Eigen::Index done = 0; done < count; done += tile)
      advance_tile(tables, start, first + done, std::min(tile, count - done), scratch);
  } else if (next % recent == 0) {
    for (Eigen::Index done = 0; done < count; done += tile)
      add_recent(next, first + done, std::min(tile, count - done), tables.count);
  }
  complete_sums(next, first, count, tables.count);
}

// Adds the newest `recent` samples, with exact weights, to the sums of the rest of the block.
void WideMemory::add_recent(Eigen::Index position, Eigen::Index first, Eigen::Index count,
                            Eigen::Index tables) {
  for (Eigen::Index table = 0; table < tables; ++table) {
    multiply_add(count, recent, block - position, {&samples_(first, position), samples_.rows()},
                 {&near_(0, table * block), recent}, {&sums_(first, table * block + position), sums_.rows()});
  }
}

void WideMemory::advance_tile(const MemoryTables& tables, const FirstSampleWeights& start, Eigen::Index first,
                              Eigen::Index count, Scratch& scratch) {
  const Eigen::Index points = spread_.rows(), slow = spread_.cols(), others = far_.rows() - points;
  const double* const decay = &tables.decay_minus_one[tables.nodes.size() - tables.exponentials];
  const auto of_tile = [&](Matrix& all, Eigen::Index node) {
    return Block(all.col(first / tile).data() + node * tile, tile);
  };
  const auto column = [](Matrix& all, Eigen::Index node) { return Block(all.data() + node * tile, tile); };
  auto& [gathered, input, joined, weighted] = scratch;
  gathered.setZero();
  multiply_add(count, block, gathered.cols(), {&samples_(first, 0), samples_.rows()}, gather_, gathered);
  input.setZero();
  multiply_add(count, points, slow, gathered, spread_, input);
  advance_columns(count, slow, decay, input, of_tile(states_, 0), of_tile(carries_, 0));
  advance_columns(count, others, decay + slow, column(gathered, points), of_tile(states_, slow),
                  of_tile(carries_, slow));
  auto samples = samples_.middleRows(first, count);
  samples.leftCols(recent) = samples.rightCols(recent);
  joined.setZero();
  multiply_add(count, slow, points, of_tile(states_, 0), condense_, joined);
  sums_.middleRows(first, count).setZero();
  const Eigen::Index fillers = tables.far.cols() - far_.rows();
  for (Eigen::Index table = 0; table < tables.count; ++table) {
    for (Eigen::Index node = 0; node < far_.rows(); ++node) {
      const Block state = node < points ? column(joined, node) : of_tile(states_, slow + node - points);
      const double factor = tables.factors(fillers + node, table);
      const double of_first = start.weighted()(fillers + node, table);
      weighted.col(node).head(count) =
          factor * Eigen::Map<const Vec>(state.data, count) + of_first * first_.segment(first, count);
    }
    multiply_add(count, far_.rows(), block, weighted, far_, {&sums_(first, table * block), sums_.rows()});
  }
  if (start.has_exact_after_first_block()) add_exact(start, first, count);
  add_recent(0, first, count, tables.count);
}

// Completes the sums of a step with the samples of its own group of `recent` steps, in their order.
void WideMemory::complete_sums(Eigen::Index position, Eigen::Index first, Eigen::Index count,
                               Eigen::Index tables) {
  const Eigen::Index newest = position % recent, oldest = position - newest;
  for (Eigen::Index table = 0; table < tables; ++table) {
    current_.col(table).segment(first, count) = sums_.col(table * block + position).segment(first, count);
    multiply_add(count, newest, 1, {&samples_(first, recent + oldest), samples_.rows()},
                 {&inner_(0, table * recent + newest), recent}, {&current_(first, table), current_.rows()});
  }
}

std::size_t WideMemory::bytes() const {
  const auto of_components =
      samples_.size() + sums_.size() + current_.size() + first_.size() + 2 * states_.size();
  const auto of_tables =
      gather_.size() + inner_.size() + near_.size() + far_.size() + spread_.size() + condense_.size();
  return sizeof(double) * static_cast<std::size_t>(of_components + of_tables);
}

}  // namespace fde
