// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/start_weights/start_correction.hpp"

#include <algorithm>

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {
namespace {

// From this number of rows on, a block of their sums takes memory, and with one table weights are computed
// first and then applied to all rows.
constexpr std::size_t many = 64;

}  // namespace

StartingCorrection::StartingCorrection(const std::vector<WeightTable>& tables,
                                       const std::vector<double>& powers, int steps)
    : steps_(steps) {
  for (const auto& table : tables) {
    auto found = std::ranges::find(tables_, table);
    if (found == tables_.end()) {
      found = tables_.insert(found, table);
      of_orders_.push_back(starting_weights(table, powers, steps));
    }
    row_.push_back(static_cast<std::size_t>(found - tables_.begin()));
  }
  near_ = static_cast<int>(of_orders_.front()->tabulated.rows());
  one_column_a_row_ = tables_.size() > 1 || tables.size() < many;
  if (tables.size() < many) block_ = 4 * lanes;
  f_.setZero(rounded_up(std::ssize(tables)), std::ssize(powers));
  sums_.setZero(f_.rows(), block_);
}

Matrix StartingCorrection::first_weights(std::size_t table) const {
  const auto& tabulated = of_orders_[table]->tabulated;
  const Eigen::Index steps = tabulated.cols() - 1;
  Matrix all = tabulated.topRows(steps);
  for (Eigen::Index n = 1; n <= steps; ++n) {
    all.row(n - 1).head(n) += fde::first_weights(tables_[table], n).reverse().transpose();
    all(n - 1, n) += 1.0;
  }
  return all;
}

void StartingCorrection::push(In f) {
  if (pushed_ < count()) f_.col(pushed_++).head(rows()) = f;
}

void StartingCorrection::add(int n, Out sums) {
  const int first = n - static_cast<int>((n - 1) % block_);
  if (first != first_) compute_block(first);
  const double* const of_step = sums_.col(n - first).data();
  for_each_component(rows(), [&](Eigen::Index i) { sums[i] += of_step[i]; });
}

void StartingCorrection::compute_block(int n) {
  first_ = n;
  if (n > near_) load_piece(n);
  if (one_column_a_row_) {
    sums_.topRows(rows()) = values(n, rows()).transpose();
    for (Eigen::Index i = 0; i < rows(); ++i) {
      const auto stored = stored_rows(of_row(i), n);
      if (stored.rows() == 0) continue;
      sums_.row(i).head(stored.rows()) += (stored * f_.row(i).transpose()).transpose();
    }
  } else {
    Matrix weights = values(n, count());
    const auto stored = stored_rows(*of_orders_.front(), n);
    if (stored.rows() > 0) weights.topRows(stored.rows()) += stored;
    sums_.setZero();
    multiply_add(f_.rows(), count(), block_, f_, Matrix(weights.transpose()), sums_);
  }
}

Eigen::Block<const Matrix> StartingCorrection::stored_rows(const StartingWeights& weights, int n) const {
  const bool near = n <= near_;
  const Matrix& all = near ? weights.tabulated : weights.pieces[piece_].decaying;
  const Eigen::Index row = std::min(n - 1 - (near ? 0 : static_cast<Eigen::Index>(begin_)), all.rows());
  return all.block(row, 0, std::min(all.rows() - row, block_), all.cols());
}

Matrix StartingCorrection::values(int n, Eigen::Index columns) const {
  Matrix sums = Matrix::Zero(block_, columns);
  if (n <= near_) return sums;
  const Eigen::Index degrees = coefficients_.smooth.rows();
  const Vec x =
      2.0 * (Vec::LinSpaced(block_, n, n + static_cast<double>(block_ - 1)).array() - begin_) / begin_ - 1.0;
  Matrix polynomials(block_, degrees);
  polynomials.col(0).setOnes();
  polynomials.col(1) = x;
  for (Eigen::Index k = 2; k < degrees; ++k)
    polynomials.col(k) = 2.0 * x.cwiseProduct(polynomials.col(k - 1)) - polynomials.col(k - 2);
  multiply_add(block_, degrees, columns, polynomials, coefficients_.smooth, sums);
  if (coefficients_.alternating.size() > 0) {
    for (Eigen::Index k = 0; k < block_; ++k) {
      if ((n + k) % 2 != 0) polynomials.row(k) *= -1.0;
    }
    multiply_add(block_, degrees, columns, polynomials, coefficients_.alternating, sums);
  }
  return sums;
}

// Loads the coefficients of the piece with step n > near_.
void StartingCorrection::load_piece(double n) {
  piece_ = 0;
  double begin = near_;
  for (; 2.0 * begin < n; begin *= 2.0) ++piece_;
  if (begin == begin_) return;
  begin_ = begin;
  coefficients_ = of_orders_.front()->pieces[piece_];
  if (!one_column_a_row_) return;
  const bool alternates = std::ranges::any_of(
      of_orders_, [&](const auto& weights) { return weights->pieces[piece_].alternating.size() > 0; });
  coefficients_.smooth.resize(coefficients_.smooth.rows(), rows());
  coefficients_.alternating.setZero(alternates ? coefficients_.smooth.rows() : 0, rows());
  for (Eigen::Index i = 0; i < rows(); ++i) {
    const auto& of = of_row(i).pieces[piece_];
    coefficients_.smooth.col(i) = of.smooth * f_.row(i).transpose();
    if (of.alternating.size() > 0) coefficients_.alternating.col(i) = of.alternating * f_.row(i).transpose();
  }
}

std::size_t StartingCorrection::bytes() const {
  const auto doubles =
      f_.size() + coefficients_.smooth.size() + coefficients_.alternating.size() + sums_.size();
  std::size_t bytes = sizeof(double) * static_cast<std::size_t>(doubles);
  for (const auto& weights : of_orders_) bytes += weights->bytes(steps_);
  return bytes;
}

void StartingCorrection::state(Archive& archive) {
  archive(f_);
  archive.count(pushed_, 0, count());
  first_ = 0;
  begin_ = 0.0;
}

}  // namespace fde
