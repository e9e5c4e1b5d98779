// SPDX-License-Identifier: MIT
#include "fdebench/schemes/solvers/sine_transform.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "fdebench/schemes/history/block_kernels.hpp"
#include "fdebench/schemes/history/parallel_for_rows.hpp"

namespace fde {
namespace {

constexpr Eigen::Index columns_together = 64, rows_together = 64;  // of a product, in the second cache

// sin(pi a / N) for an integer a, its argument reduced to [0, pi/2] in integers.
class Sines {
 public:
  explicit Sines(Eigen::Index intervals) : intervals_(intervals), values_(2 * intervals) {
    for (Eigen::Index a = 0; a < intervals; ++a) {
      const Eigen::Index angle = std::min(a, intervals - a);
      values_[a] = std::sin(std::numbers::pi * static_cast<double>(angle) / static_cast<double>(intervals));
      values_[a + intervals] = -values_[a];
    }
  }
  [[nodiscard]] double operator()(Eigen::Index a) const { return values_[a % (2 * intervals_)]; }

 private:
  Eigen::Index intervals_;
  Vec values_;
};

// Calls work(first, count) for panels of columns of the modes.
void for_each_column_panel(const Matrix& modes, const std::function<void(Eigen::Index, Eigen::Index)>& work) {
  const Eigen::Index panels = (modes.cols() + columns_together - 1) / columns_together;
  parallel_for_parts(panels, columns_together * modes.rows(), [&](Eigen::Index panel) {
    const Eigen::Index first = panel * columns_together;
    work(first, std::min(columns_together, modes.cols() - first));
  });
}

// c += a b, with blocks of rows of a that stay in the cache for all columns of b.
void add_product(const Matrix& a, Eigen::Index inner, Eigen::Index columns, ConstBlock b, Block c) {
  for (Eigen::Index row = 0; row < a.rows(); row += rows_together) {
    multiply_add(std::min(rows_together, a.rows() - row), inner, columns, {a.data() + row, a.rows()}, b,
                 {c.data + row, c.stride});
  }
}

}  // namespace

SineTransform::SineTransform(Eigen::Index n)
    : n_(n),
      half_((n + 1) / 2),
      even_(n / 2),
      odd_rows_(rounded_up(half_)),
      even_rows_(rounded_up(even_)),
      odd_(Matrix::Zero(odd_rows_, half_)),
      even_sines_(Matrix::Zero(even_rows_, even_)),
      twice_cosines_(odd_rows_ + even_rows_) {
  const Sines sine(n + 1);
  const auto cosine = [&](Eigen::Index k) {
    return std::cos(std::numbers::pi * static_cast<double>(k) / static_cast<double>(n + 1));
  };
  twice_cosines_.setConstant(2.0 * cosine(1));
  for (Eigen::Index row = 0; row < half_; ++row) {
    for (Eigen::Index i = 0; i < half_; ++i) odd_(row, i) = sine((2 * row + 1) * (i + 1));
    twice_cosines_[row] = 2.0 * cosine(2 * row + 1);
  }
  for (Eigen::Index row = 0; row < even_; ++row) {
    for (Eigen::Index i = 0; i < even_; ++i) even_sines_(row, i) = sine((2 * row + 2) * (i + 1));
    twice_cosines_[odd_rows_ + row] = 2.0 * cosine(2 * row + 2);
  }
  const double scale = 2.0 / static_cast<double>(n + 1);
  odd_back_ = Matrix::Zero(odd_rows_, half_);
  odd_back_.topRows(half_) = scale * odd_.topRows(half_).transpose();
  even_back_ = Matrix::Zero(even_rows_, even_);
  even_back_.topRows(even_) = scale * even_sines_.topRows(even_).transpose();
}

void SineTransform::forward(const double* field, Matrix& modes) const {
  for_each_column_panel(modes, [&](Eigen::Index first, Eigen::Index count) {
    Matrix sums(half_, count), differences(even_, count);
    modes.middleCols(first, count).setZero();
    for (Eigen::Index j = 0; j < count; ++j) {
      const Eigen::Map<const Vec> column(field + (first + j) * n_, n_);
      sums.col(j).head(even_) = column.head(even_) + column.tail(even_).reverse();
      differences.col(j) = column.head(even_) - column.tail(even_).reverse();
      if (half_ > even_) sums(even_, j) = column[even_];
    }
    add_product(odd_, half_, count, sums, {&modes(0, first), modes.rows()});
    add_product(even_sines_, even_, count, differences, {&modes(odd_rows_, first), modes.rows()});
  });
}

void SineTransform::backward(const Matrix& modes, double* field) const {
  for_each_column_panel(modes, [&](Eigen::Index first, Eigen::Index count) {
    Matrix sums = Matrix::Zero(odd_rows_, count), differences = Matrix::Zero(even_rows_, count);
    add_product(odd_back_, half_, count, {&modes(0, first), modes.rows()}, sums);
    add_product(even_back_, even_, count, {&modes(odd_rows_, first), modes.rows()}, differences);
    for (Eigen::Index j = 0; j < count; ++j) {
      Eigen::Map<Vec> column(field + (first + j) * n_, n_);
      column.head(even_) = sums.col(j).head(even_) + differences.col(j).head(even_);
      column.tail(even_).reverse() = sums.col(j).head(even_) - differences.col(j).head(even_);
      if (half_ > even_) column[even_] = sums(even_, j);
    }
  });
}

}  // namespace fde
