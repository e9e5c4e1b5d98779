// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/start_weights/start_correction.hpp"

#include <algorithm>

namespace fde {
namespace {

// sum_k coefficients[k] T_k(x), by Clenshaw's recurrence.
template <class Values>
Values chebyshev_sum(const double* coefficients, Eigen::Index count, const Values& x) {
  Values next = Values::Zero(), after = Values::Zero();
  for (Eigen::Index k = count - 1; k > 0; --k) {
    const Values value = coefficients[k] + 2.0 * x * next - after;
    after = next;
    next = value;
  }
  return coefficients[0] + x * next - after;
}

}  // namespace

StartingCorrection::StartingCorrection(const std::vector<WeightTable>& tables,
                                       const std::vector<double>& powers, int steps) {
  for (const auto& table : tables) {
    auto found = std::ranges::find(tables_, table);
    if (found == tables_.end()) {
      found = tables_.insert(found, table);
      of_orders_.push_back(starting_weights(table, powers, steps));
    }
    row_.push_back(static_cast<std::size_t>(found - tables_.begin()));
  }
  near_ = static_cast<int>(of_orders_.front()->tabulated.rows());
  sums_.setZero(block, std::ssize(tables));
}

Matrix StartingCorrection::weights(int n) const {
  Matrix all(std::ssize(row_), of_orders_.front()->tabulated.cols());
  for (Eigen::Index i = 0; i < all.rows(); ++i) {
    all.row(i) = of_row(i).tabulated.row(n - 1);
    all.row(i).head(n) += first_weights(tables_[row_[static_cast<std::size_t>(i)]], n).reverse().transpose();
    all(i, n) += 1.0;
  }
  return all;
}

void StartingCorrection::start(const Matrix& f) { f_ = f.transpose(); }

void StartingCorrection::add(int n, Out sums) {
  const int first = (n - 1) / block * block + 1;
  if (first != first_) compute_block(first);
  sums += sums_.row(n - first).transpose();
}

void StartingCorrection::compute_block(int n) {
  first_ = n;
  if (n <= near_) {
    for (Eigen::Index i = 0; i < sums_.cols(); ++i)
      sums_.col(i) = of_row(i).tabulated.middleRows(n - 1, block) * f_.col(i);
    return;
  }
  std::size_t piece = 0;
  double begin = near_;
  for (; 2.0 * begin < n; begin *= 2.0) ++piece;
  if (begin != begin_) {
    begin_ = begin;
    load_piece(piece);
  }
  const Block steps = Block::LinSpaced(n, n + block - 1);
  const Block x = 2.0 * (steps - begin) / begin - 1.0;
  for (Eigen::Index i = 0; i < sums_.cols(); ++i) {
    Block values = chebyshev_sum(smooth_.col(i).data(), smooth_.rows(), x);
    if (alternating_.size() > 0) {
      Block other = chebyshev_sum(alternating_.col(i).data(), alternating_.rows(), x);
      for (int k = 0; k < block; ++k) values[k] += (n + k) % 2 == 0 ? other[k] : -other[k];
    }
    sums_.col(i) = values.matrix();
    const Matrix& decaying = of_row(i).pieces[piece].decaying;
    const Eigen::Index row = n - 1 - static_cast<Eigen::Index>(begin);
    if (row < decaying.rows()) sums_.col(i) += decaying.middleRows(row, block) * f_.col(i);
  }
}

void StartingCorrection::load_piece(std::size_t piece) {
  const auto rows = sums_.cols();
  const auto& any = of_row(0).pieces[piece].smooth;
  smooth_.resize(any.rows(), rows);
  const bool alternates = std::ranges::any_of(
      of_orders_, [&](const auto& weights) { return weights->pieces[piece].alternating.size() > 0; });
  if (alternates) alternating_.setZero(any.rows(), rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const auto& of = of_row(i).pieces[piece];
    smooth_.col(i) = of.smooth * f_.col(i);
    if (of.alternating.size() > 0) alternating_.col(i) = of.alternating * f_.col(i);
  }
}

std::size_t StartingCorrection::bytes() const {
  auto doubles = f_.size() + smooth_.size() + alternating_.size() + sums_.size();
  for (const auto& weights : of_orders_) {
    doubles += weights->tabulated.size();
    for (const auto& piece : weights->pieces)
      doubles += piece.smooth.size() + piece.alternating.size() + piece.decaying.size();
  }
  return sizeof(double) * static_cast<std::size_t>(doubles);
}

void StartingCorrection::state(Archive& archive) {
  archive.resizable(f_);
  first_ = 0;
  begin_ = 0.0;
}

}  // namespace fde
