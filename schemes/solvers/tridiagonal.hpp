// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// Elimination without pivoting for tridiagonal matrices. determinant_sign() is for real ones.
template <class Scalar>
class TridiagonalLu {
 public:
  using Values = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  using Rows = Eigen::SparseMatrix<Scalar>;

  static bool is_applicable(const Rows& matrix) {
    for (Eigen::Index j = 0; j < matrix.outerSize(); ++j) {
      for (typename Rows::InnerIterator entry(matrix, j); entry; ++entry)
        if (std::abs(entry.row() - j) > 1) return false;
    }
    return true;
  }

  // Returns false where a row is not diagonally dominant. Otherwise no pivot is smaller than the entry on its
  // right.
  bool factorise(const Rows& matrix) {
    copy_bands(matrix);
    if (!(inverse_.array().abs() >= below_.array().abs() + above_.array().abs()).all()) return false;
    sign_ = 1;
    for (Eigen::Index i = 0; i < inverse_.size(); ++i) {
      if (i > 0) {
        below_[i] *= inverse_[i - 1];
        inverse_[i] -= below_[i] * above_[i - 1];
      }
      if (std::real(inverse_[i]) < 0.0) sign_ = -sign_;
      inverse_[i] = 1.0 / inverse_[i];
    }
    return inverse_.allFinite();
  }

  [[nodiscard]] int determinant_sign() const { return sign_; }

  void solve(Values& b) const {
    Scalar last = 0.0;
    for (Eigen::Index i = 0; i < b.size(); ++i) b[i] = last = b[i] - below_[i] * last;
    last = 0.0;
    for (Eigen::Index i = b.size() - 1; i >= 0; --i) b[i] = last = (b[i] - above_[i] * last) * inverse_[i];
  }

 private:
  void copy_bands(const Rows& matrix) {
    below_ = above_ = inverse_ = Values::Zero(matrix.rows());
    for (Eigen::Index j = 0; j < matrix.outerSize(); ++j) {
      for (typename Rows::InnerIterator entry(matrix, j); entry; ++entry) {
        Values& line = entry.row() == j ? inverse_ : entry.row() < j ? above_ : below_;
        line[entry.row()] = entry.value();
      }
    }
  }

  Values below_, above_, inverse_;  // multipliers, entries right of the diagonal, inverse pivots
  int sign_ = 1;
};

}  // namespace fde
