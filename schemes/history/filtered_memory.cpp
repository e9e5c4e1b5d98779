// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/filtered_memory.hpp"

#include <algorithm>
#include <cmath>

#include "fdebench/schemes/history/parallel_for_rows.hpp"
#include "fdebench/schemes/history/weights/exponential_sum.hpp"
#include "fdebench/schemes/history/zero_matrix.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

namespace {

// Column p: phi_(k-p) for k > p, and 0 above and below.
Matrix filter_of_group(const std::vector<double>& filter) {
  const auto last = std::ssize(filter) - 1;
  Matrix columns = Matrix::Zero(lanes + rounded_up(last), lanes);
  for (Eigen::Index p = 0; p < lanes; ++p)
    for (Eigen::Index i = 1; i <= last; ++i) columns(p + i, p) = filter[static_cast<std::size_t>(i)];
  return columns;
}

// w(1), w(2), ..., or the differences w(k) - w(k-1) for running sums.
Vec weights_of_lags(const WeightTable& table, Eigen::Index count) {
  auto weights = table.family->first_weights(table.order, static_cast<std::size_t>(count));
  for (std::size_t k = weights.size(); table.order > 1.0 && --k > 0;) weights[k] -= weights[k - 1];
  return Vec::NullaryExpr(
      count, [&](Eigen::Index k) { return static_cast<double>(weights[static_cast<std::size_t>(k)]); });
}

}  // namespace

FilteredMemory::FilteredMemory(const WeightTable& table, Eigen::Index components, int steps, double tolerance)
    : running_sums_(table.order > 1.0),
      filter_(filter_of_group(table.family->filter(table.order))),
      tails_(Matrix::Zero(filter_.rows(), components)),
      filtered_(components),
      totals_(components) {
  const WeightTable binomial{&families::grunwald_letnikov, table.order};
  if (constant_weight(binomial)) return;
  memory_.emplace(std::vector{binomial}, components, steps, tolerance);
}

void FilteredMemory::push(In sample) {
  for_each_component(sample.size(), [&](Eigen::Index i) { filtered_[i] = sample[i] + tails_(position_, i); });
  if (!memory_ || running_sums_) totals_.add(filtered_);
  if (running_sums_) {
    for (Eigen::Index i = 0; i < filtered_.size(); ++i) filtered_[i] = totals_[i];
  }
  if (memory_) memory_->push(filtered_);
  const Eigen::Index rows = tails_.rows();
  add_outer_product(rows / lanes, filter_.col(position_).data(), sample.data(), sample.size(), lanes, tails_);
  if (++position_ < lanes) return;
  position_ = 0;
  for (Eigen::Index i = 0; i < sample.size(); ++i) {
    auto tail = tails_.col(i);
    std::shift_left(tail.begin(), tail.end(), lanes);
    tail.tail(lanes).setZero();
  }
}

std::size_t FilteredMemory::bytes() const {
  const auto doubles = filter_.size() + tails_.size() + 3 * filtered_.size();
  return sizeof(double) * static_cast<std::size_t>(doubles) + (memory_ ? memory_->bytes() : 0);
}

void FilteredMemory::state(Archive& archive) {
  archive.count(position_, 0, lanes - 1);
  archive(tails_, totals_, memory_);
}

WideFilteredMemory::WideFilteredMemory(const WeightTable& table, Eigen::Index components, int steps,
                                       double tolerance)
    : components_(components),
      exact_lags_(exact_lags(*table.family->multistep, steps + 2.0)),
      near_(exact_lags_, block),
      inner_(Matrix::Zero(group, group)) {
  const Vec exact = weights_of_lags(table, exact_lags_ + block);
  for (Eigen::Index column = 0; column < block; ++column)
    near_.col(column) = exact.segment(column, exact_lags_).reverse();
  for (Eigen::Index column = 1; column < group; ++column)
    inner_.col(column).head(column) = exact.head(column).reverse();
  if (static_cast<double>(exact_lags_) < steps + 2.0) set_exponentials(table, steps + 2.0, tolerance);
  const Eigen::Index rows = rounded_up(components, tile), tiles = rows / tile;
  make_zero(samples_, tile * (exact_lags_ + block), tiles);
  make_zero(states_, tile * factors_.size(), tiles);
  make_zero(carries_, tile * factors_.size(), tiles);
  current_.setZero(rows);
  if (table.order > 1.0) totals_.emplace(components);
}

Eigen::Index WideFilteredMemory::exact_lags(const MultistepRule& rule, double longest) {
  constexpr double half_unit = 0x1p-54;
  const double decayed = rule.decay == 0.0 ? 3.0 : std::log(half_unit) / std::log(rule.decay);
  return rounded_up(static_cast<Eigen::Index>(std::ceil(std::min(decayed, longest))), block);
}

void WideFilteredMemory::set_exponentials(const WeightTable& table, double longest, double tolerance) {
  const WeightTable binomial{&families::grunwald_letnikov, table.order};
  const auto sum =
      exponential_sum(kernel_exponent(binomial), static_cast<double>(exact_lags_), longest, tolerance);
  const Vec& nodes = sum.nodes;
  decay_minus_one_ = (-double{block} * nodes).array().expm1();
  factors_ = weight_coefficients(binomial, sum).binaryExpr(nodes, [&](double coefficient, double node) {
    return coefficient * table.family->regular_part(table.order, node).real();
  });
  gather_.resize(block, nodes.size());
  far_.resize(nodes.size(), block);
  for (Eigen::Index k = 0; k < block; ++k) {
    gather_.row(k) = (-static_cast<double>(block - 1 - k) * nodes).array().exp().transpose();
    far_.col(k) = (-static_cast<double>(exact_lags_ + 1 + k) * nodes).array().exp();
  }
}

void WideFilteredMemory::push(In sample) {
  if (totals_) totals_->add(sample);
  const Eigen::Index next = (position_ + 1) % block;
  parallel_for_rows(current_.size(), tile, [&](Eigen::Index first, Eigen::Index count) {
    for (Eigen::Index done = 0; done < count; done += tile) push_tile(sample, first + done, next);
  });
  if (next == 0) begin_ = (begin_ + block) % (exact_lags_ + block);
  position_ = next;
}

void WideFilteredMemory::push_tile(In sample, Eigen::Index first, Eigen::Index next) {
  double* const newest = columns(first, begin_ + position_).data;
  const Eigen::Index real = std::min(tile, components_ - first);
  for (Eigen::Index i = 0; i < real; ++i) newest[i] = totals_ ? (*totals_)[first + i] : sample[first + i];
  Eigen::Index place = begin_ + next;
  if (next == 0) {
    advance_tile(first);
    place = (begin_ + block) % (exact_lags_ + block);
  } else if (next % group == 0) {
    multiply_add(tile, group, block - next, columns(first, place - group),
                 {&near_(exact_lags_ - group, 0), exact_lags_}, columns(first, place));
  }
  std::copy_n(columns(first, place).data, tile, &current_[first]);
  const Eigen::Index in_group = next % group;
  multiply_add(tile, in_group, 1, columns(first, place - in_group), {&inner_(0, in_group), group},
               {&current_[first], tile});
}

void WideFilteredMemory::advance_tile(Eigen::Index first) {
  const Eigen::Index all = exact_lags_ + block, oldest = (begin_ + block) % all, nodes = factors_.size();
  const Block sums = columns(first, oldest), states(states_.col(first / tile).data(), tile);
  Matrix weighted = Matrix::Zero(tile, nodes);
  if (nodes > 0) {
    multiply_add(tile, block, nodes, sums, gather_, weighted);
    advance_columns(tile, nodes, decay_minus_one_.data(), weighted, states,
                    {carries_.col(first / tile).data(), tile});
    weighted = Eigen::Map<const Matrix>(states.data, tile, nodes) * factors_.asDiagonal();
  }
  std::fill_n(sums.data, tile * block, 0.0);
  if (nodes > 0) multiply_add(tile, nodes, block, weighted, far_, sums);
  // The other columns in the order of their times: those after the oldest block, then those before it.
  const Eigen::Index after = all - oldest - block;
  multiply_add(tile, after, block, columns(first, oldest + block), near_, sums);
  multiply_add(tile, oldest, block, columns(first, 0), {near_.data() + after, exact_lags_}, sums);
}

std::size_t WideFilteredMemory::bytes() const {
  const auto doubles = near_.size() + gather_.size() + far_.size() + samples_.size() + 2 * states_.size() +
                       current_.size() + (totals_ ? 2 * components_ : 0);
  return sizeof(double) * static_cast<std::size_t>(doubles);
}

void WideFilteredMemory::state(Archive& archive) {
  archive.count(begin_, 0, exact_lags_);
  archive.count(position_, 0, block - 1);
  archive(samples_, states_, carries_, current_, totals_);
}

}  // namespace fde
