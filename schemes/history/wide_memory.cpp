// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/wide_memory.hpp"

#include <algorithm>
#include <array>

#include "fdebench/schemes/history/parallel_for_rows.hpp"
#include "fdebench/schemes/history/zero_matrix.hpp"

namespace fde {

WideMemory::WideMemory(const MemoryTables& tables, Eigen::Index components)
    : components_(components),
      tables_(tables.count),
      inner_(tables.inner.transpose()),
      near_(tables.near.transpose()),
      current_is_known_(static_cast<std::size_t>(tables.count), false) {
  const Eigen::Index fillers = tables.nodes.size() - tables.exponentials, points = tables.points();
  const Eigen::Index slow = std::max(tables.slow - fillers, Eigen::Index{0});
  const Eigen::Index together = points + tables.exponentials - slow;
  gather_ = tables.gather.bottomRows(together).transpose();
  spread_ = tables.spread.bottomRows(slow).transpose();
  condense_ = tables.condense.rightCols(slow).transpose();
  far_ = tables.far.rightCols(together).transpose();
  const Eigen::Index rows = rounded_up(components), tiles = rounded_up(rows, tile) / tile;
  const Eigen::Index strips = rounded_up(rows, strip) / strip;
  pitch_ = std::min(rows, strip) + lanes;
  first_.setZero(rows);
  make_zero(samples_, pitch_ * (recent + block), strips);
  make_zero(sums_, pitch_ * tables_ * block, strips);
  make_zero(states_, tile * tables.exponentials, tiles);
  make_zero(carries_, tile * tables.exponentials, tiles);
}

ConstBlock WideMemory::rows_of(const Matrix& all, Eigen::Index column, Eigen::Index first) const {
  return {all.col(first / strip).data() + column * pitch_ + first % strip, pitch_};
}

Block WideMemory::rows_of(Matrix& all, Eigen::Index column, Eigen::Index first) const {
  return {all.col(first / strip).data() + column * pitch_ + first % strip, pitch_};
}

Eigen::Index WideMemory::rows_in_tile(Eigen::Index first) const {
  return std::min(tile, first_.size() - first);
}

void WideMemory::begin(In first, const FirstSampleWeights& start) {
  first_.head(components_) = first;
  for (Eigen::Index row = 0; row < first_.size(); row += tile) add_exact(start, row, rows_in_tile(row));
}

// Adds x_0 times its exact weights to the sums of a block.
void WideMemory::add_exact(const FirstSampleWeights& start, Eigen::Index first, Eigen::Index count) {
  multiply_add(count, 1, tables_ * block, {first_.data() + first, first_.size()}, {start.exact().data(), 1},
               rows_of(sums_, 0, first));
}

void WideMemory::push(const MemoryTables& tables, Eigen::Index position, In sample,
                      const FirstSampleWeights& start) {
  const Eigen::Index next = (position + 1) % block;
  std::fill(current_is_known_.begin(), current_is_known_.end(), false);
  parallel_for_rows(first_.size(), strip, [&](Eigen::Index part, Eigen::Index rows) {
    Scratch scratch;
    for (Eigen::Index first = part; first < part + rows; first += tile) {
      const Eigen::Index count = rows_in_tile(first), real = std::min(count, components_ - first);
      std::copy_n(sample.data() + first, real, rows_of(samples_, recent + position, first).data);
      if (next == 0) {
        advance_tile(tables, start, first, count, scratch);
      } else if (next % recent == 0) {
        add_recent(next, first, count);
      }
    }
  });
}

// The sums are completed with the samples of their own group of `recent` steps, in the order of the steps.
void WideMemory::convolve(Eigen::Index table, Eigen::Index position, double* result) const {
  const Eigen::Index newest = position % recent, oldest = position - newest;
  parallel_for_rows(components_, strip, [&](Eigen::Index part, Eigen::Index rows) {
    alignas(64) std::array<double, tile> sum;
    for (Eigen::Index first = part; first < part + rows; first += tile) {
      const Eigen::Index count = rows_in_tile(first), real = std::min(count, components_ - first);
      std::copy_n(rows_of(sums_, table * block + position, first).data, count, sum.data());
      multiply_add(count, newest, 1, rows_of(samples_, recent + oldest, first),
                   {&inner_(0, table * recent + newest), recent}, {sum.data(), tile});
      std::copy_n(sum.data(), real, result + first);
    }
  });
}

const double* WideMemory::sums(Eigen::Index table, Eigen::Index position) const {
  current_.resize(components_, tables_);
  if (!current_is_known_[static_cast<std::size_t>(table)])
    convolve(table, position, current_.col(table).data());
  current_is_known_[static_cast<std::size_t>(table)] = true;
  return current_.col(table).data();
}

// Adds the newest `recent` samples, with exact weights, to the sums of the rest of the block.
void WideMemory::add_recent(Eigen::Index position, Eigen::Index first, Eigen::Index count) {
  for (Eigen::Index table = 0; table < tables_; ++table) {
    multiply_add(count, recent, block - position, rows_of(samples_, position, first),
                 {&near_(0, table * block), recent}, rows_of(sums_, table * block + position, first));
  }
}

void WideMemory::advance_tile(const MemoryTables& tables, const FirstSampleWeights& start, Eigen::Index first,
                              Eigen::Index count, Scratch& scratch) {
  const Eigen::Index points = spread_.rows(), slow = spread_.cols(), others = far_.rows() - points;
  const double* const decay = tables.decay_minus_one.data() + (tables.nodes.size() - tables.exponentials);
  const auto of_tile = [&](Matrix& all, Eigen::Index node) {
    return Block(all.col(first / tile).data() + node * tile, tile);
  };
  const auto column = [](Matrix& all, Eigen::Index node) { return Block(all.data() + node * tile, tile); };
  auto& [gathered, input, joined, weighted] = scratch;
  gathered.setZero(tile, far_.rows());
  multiply_add(count, block, gathered.cols(), rows_of(samples_, 0, first), gather_, gathered);
  input.setZero(tile, slow);
  multiply_add(count, points, slow, gathered, spread_, input);
  advance_columns(count, slow, decay, input, of_tile(states_, 0), of_tile(carries_, 0));
  advance_columns(count, others, decay + slow, column(gathered, points), of_tile(states_, slow),
                  of_tile(carries_, slow));
  for (Eigen::Index k = 0; k < recent; ++k)
    std::copy_n(rows_of(samples_, block + k, first).data, count, rows_of(samples_, k, first).data);
  joined.setZero(tile, points);
  multiply_add(count, slow, points, of_tile(states_, 0), condense_, joined);
  for (Eigen::Index k = 0; k < tables_ * block; ++k) std::fill_n(rows_of(sums_, k, first).data, count, 0.0);
  weighted.resize(tile, far_.rows());
  const Eigen::Index fillers = tables.far.cols() - far_.rows();
  for (Eigen::Index table = 0; table < tables.count; ++table) {
    for (Eigen::Index node = 0; node < far_.rows(); ++node) {
      const Block state = node < points ? column(joined, node) : of_tile(states_, slow + node - points);
      const double factor = tables.factors(fillers + node, table);
      const double of_first = start.weighted()(fillers + node, table);
      weighted.col(node).head(count) =
          factor * Eigen::Map<const Vec>(state.data, count) + of_first * first_.segment(first, count);
    }
    multiply_add(count, far_.rows(), block, weighted, far_, rows_of(sums_, table * block, first));
  }
  if (start.has_exact_after_first_block()) add_exact(start, first, count);
  add_recent(0, first, count);
}

std::size_t WideMemory::bytes() const {
  const auto of_components =
      samples_.size() + sums_.size() + current_.size() + first_.size() + 2 * states_.size();
  const auto of_tables =
      gather_.size() + inner_.size() + near_.size() + far_.size() + spread_.size() + condense_.size();
  return sizeof(double) * static_cast<std::size_t>(of_components + of_tables);
}

}  // namespace fde
