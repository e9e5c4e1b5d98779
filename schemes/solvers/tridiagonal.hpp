// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include "fdebench/schemes/history/parallel_for_rows.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// Elimination without pivoting for tridiagonal matrices, from both ends to the row in the middle, so that two
// threads share it. determinant_sign() is for real ones.
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

  // Returns false where a row is not diagonally dominant. Otherwise no pivot is smaller than the entry beside
  // it towards the middle.
  bool factorise(const Rows& matrix) {
    copy_bands(matrix);
    if (!(inverse_.array().abs() >= below_.array().abs() + above_.array().abs()).all()) return false;
    sign_ = 1;
    const Eigen::Index middle = this->middle(), last = inverse_.size() - 1;
    for (Eigen::Index i = 0; i < middle; ++i) eliminate(i, i - 1, below_, above_);
    for (Eigen::Index i = last; i > middle; --i) eliminate(i, i + 1, above_, below_);
    if (middle < last) eliminate_neighbour(middle, middle + 1, above_, below_);
    eliminate(middle, middle - 1, below_, above_);
    above_.head(middle).array() *= inverse_.head(middle).array();
    below_.tail(last - middle).array() *= inverse_.tail(last - middle).array();
    return inverse_.allFinite();
  }

  [[nodiscard]] int determinant_sign() const { return sign_; }

  void solve(Values& b) const {
    const Eigen::Index middle = this->middle(), last = b.size() - 1;
    const auto scaled = [&](Eigen::Index i, const Scalar& value) { b[i] = value * inverse_[i]; };
    const auto unscaled = [&](Eigen::Index i, const Scalar& value) { b[i] = value; };
    std::array<Scalar, 2> ends{};
    parallel_for_parts(2, middle, [&](Eigen::Index half) {
      ends[half] = half == 0 ? sweep(below_, b, 0, middle, 1, Scalar{}, scaled)
                             : sweep(above_, b, last, last - middle, -1, Scalar{}, scaled);
    });
    if (middle > 0) b[middle] -= below_[middle] * ends[0];
    if (middle < last) b[middle] -= above_[middle] * ends[1];
    b[middle] *= inverse_[middle];
    parallel_for_parts(2, middle, [&](Eigen::Index half) {
      if (half == 0) {
        sweep(above_, b, middle - 1, middle, -1, b[middle], unscaled);
      } else {
        sweep(below_, b, middle + 1, last - middle, 1, b[middle], unscaled);
      }
    });
  }

 private:
  [[nodiscard]] Eigen::Index middle() const { return inverse_.size() / 2; }

  // Eliminates the entry of row i in the column of its neighbour, whose inverse pivot is known.
  void eliminate_neighbour(Eigen::Index i, Eigen::Index neighbour, Values& outer, const Values& inner) {
    outer[i] *= inverse_[neighbour];
    inverse_[i] -= outer[i] * inner[neighbour];
  }

  // The same, and inverts the pivot of row i.
  void eliminate(Eigen::Index i, Eigen::Index neighbour, Values& outer, const Values& inner) {
    if (neighbour >= 0 && neighbour < inverse_.size()) eliminate_neighbour(i, neighbour, outer, inner);
    if (std::real(inverse_[i]) < 0.0) sign_ = -sign_;
    inverse_[i] = 1.0 / inverse_[i];
  }

  // x_k = b_k - factors_k x_(k-1), where k counts `count` rows from `first` on in steps of `step` and x_(-1)
  // is `last`; stores each x_k and returns the last. Two rows at a time: only x_(k+1) = (b_(k+1) -
  // factors_(k+1) b_k) + factors_(k+1) factors_k x_(k-1) has to wait for the rows before.
  template <class Store>
  static Scalar sweep(const Values& factors, const Values& b, Eigen::Index first, Eigen::Index count,
                      Eigen::Index step, Scalar last, Store store) {
    Eigen::Index i = first;
    for (; count > 1; count -= 2, i += 2 * step) {
      const Scalar factor = factors[i + step], before = last;
      last = (b[i + step] - factor * b[i]) + (factor * factors[i]) * before;
      store(i, b[i] - factors[i] * before);
      store(i + step, last);
    }
    if (count > 0) {
      last = b[i] - factors[i] * last;
      store(i, last);
    }
    return last;
  }

  void copy_bands(const Rows& matrix) {
    below_ = above_ = inverse_ = Values::Zero(matrix.rows());
    for (Eigen::Index j = 0; j < matrix.outerSize(); ++j) {
      for (typename Rows::InnerIterator entry(matrix, j); entry; ++entry) {
        Values& line = entry.row() == j ? inverse_ : entry.row() < j ? above_ : below_;
        line[entry.row()] = entry.value();
      }
    }
  }

  // Multipliers are in below_ up to the middle and in above_ from there on. The entries towards the middle,
  // in the other one, are divided by the pivots.
  Values below_, above_, inverse_;
  int sign_ = 1;
};

}  // namespace fde
