// SPDX-License-Identifier: MIT
#include "fdebench/schemes/solvers/dense_factors.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

template class Eigen::PartialPivLU<Eigen::MatrixXd>;

namespace fde {
namespace {

// Gaussian elimination in place, column by column; a zero pivot is left, as Eigen leaves it.
template <std::size_t size, class Exchanges>
void eliminate(double* matrix, Exchanges& exchanges) {
  const auto a = [matrix](std::size_t i, std::size_t j) -> double& { return matrix[i + j * size]; };
  for (std::size_t k = 0; k < size; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < size; ++i) {
      if (std::abs(a(i, k)) > std::abs(a(pivot, k))) pivot = i;
    }
    exchanges[k] = pivot;
    if (a(pivot, k) != 0.0) {
      if (pivot != k) {
        for (std::size_t j = 0; j < size; ++j) std::swap(a(k, j), a(pivot, j));
      }
      for (std::size_t i = k + 1; i < size; ++i) a(i, k) /= a(k, k);
    }
    for (std::size_t j = k + 1; j < size; ++j) {
      for (std::size_t i = k + 1; i < size; ++i) a(i, j) -= a(i, k) * a(k, j);
    }
  }
}

// sum_j row[j stride] x[j] for 0 <= j < length, in pairwise order: rounding errors grow with log(length).
template <std::size_t length>
double product_sum(const double* row, const double* x, std::size_t stride) {
  if constexpr (length == 1) {
    return row[0] * x[0];
  } else {
    constexpr std::size_t half = length / 2;
    return product_sum<half>(row, x, stride) +
           product_sum<length - half>(row + half * stride, x + half, stride);
  }
}

// Substitution: forward for the rows i of L, backward for those of U.
template <std::size_t size, std::size_t i = 1>
void solve_lower(const double* factors, double* b) {
  if constexpr (i < size) {
    b[i] -= product_sum<i>(factors + i, b, size);
    solve_lower<size, i + 1>(factors, b);
  }
}
template <std::size_t size, std::size_t rows = size>
void solve_upper(const double* factors, double* b) {
  if constexpr (rows > 0) {
    constexpr std::size_t i = rows - 1;
    if constexpr (rows < size) b[i] -= product_sum<size - rows>(factors + i + rows * size, b + rows, size);
    b[i] /= factors[i + i * size];
    solve_upper<size, i>(factors, b);
  }
}

template <std::size_t size, class Exchanges>
void substitute(const double* factors, const Exchanges& exchanges, double* b) {
  for (std::size_t k = 0; k < size; ++k) std::swap(b[k], b[exchanges[k]]);
  solve_lower<size>(factors, b);
  solve_upper<size>(factors, b);
}

}  // namespace

DenseFactors::DenseFactors(Eigen::Index size) : size_(size) {
  const auto choose = [&]<std::size_t... less>(std::index_sequence<less...>) {
    ((size == static_cast<Eigen::Index>(less) + 1
          ? void(loops_ = {eliminate<less + 1, Exchanges>, substitute<less + 1, Exchanges>})
          : void()),
     ...);
  };
  choose(std::make_index_sequence<largest_small>());
}

void DenseFactors::factorise(const Matrix& matrix) {
  if (loops_.factorise == nullptr) {
    large_.compute(matrix);
  } else {
    std::copy_n(matrix.data(), matrix.size(), small_.begin());
    loops_.factorise(small_.data(), exchanges_);
  }
}

void DenseFactors::solve(Vec& b) const {
  if (loops_.solve == nullptr) {
    b = large_.solve(b).eval();
  } else {
    loops_.solve(small_.data(), exchanges_, b.data());
  }
}

int DenseFactors::determinant_sign() const {
  const bool is_small = loops_.solve != nullptr;
  bool even = is_small || large_.permutationP().determinant() > 0;
  double signs = 1.0;
  for (Eigen::Index k = 0; k < size_; ++k) {
    const double pivot =
        is_small ? small_[static_cast<std::size_t>(k * (size_ + 1))] : large_.matrixLU()(k, k);
    if (pivot == 0.0 || std::isnan(pivot)) return 0;
    if (is_small && exchanges_[static_cast<std::size_t>(k)] != static_cast<std::size_t>(k)) even = !even;
    signs *= pivot > 0.0 ? 1.0 : -1.0;
  }
  return (signs > 0.0) == even ? 1 : -1;
}

}  // namespace fde
