// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// The sine transform of columns of n values x_i, i = 1 ... n, with N = n + 1:
//   X_k = sum_i sin(pi i k / N) x_i,   x_i = 2/N sum_k sin(pi i k / N) X_k.
// Computed by products with the matrix of sines, halved by symmetry: modes of odd k depend on the sums x_i +
// x_(N-i), modes of even k on the differences. n/2 multiply-adds a value in an efficient loop
// (history/block_kernels) take less time than a fast Fourier transform up to n of about 700, and for longer
// columns unless n + 1 has small factors only (docs/large.md).
class SineTransform {
 public:
  explicit SineTransform(Eigen::Index n);

  // Number of rows of a matrix of modes: the modes of odd k, then those of even k, each padded to whole
  // vectors by rows without a mode.
  [[nodiscard]] Eigen::Index rows() const { return odd_rows_ + even_rows_; }
  [[nodiscard]] bool is_mode(Eigen::Index row) const {
    return row < odd_rows_ ? row < half_ : row - odd_rows_ < even_;
  }
  // 2 cos(pi k / N) of each row; of the first mode where a row has none.
  [[nodiscard]] const Vec& twice_cosines() const { return twice_cosines_; }

  // field: columns of n values, one after the other, as many as `modes` has; modes has rows() rows.
  void forward(const double* field, Matrix& modes) const;
  void backward(const Matrix& modes, double* field) const;

 private:
  Eigen::Index n_;
  Eigen::Index half_, even_;  // number of sums and modes of odd k; number of differences and modes of even k
  Eigen::Index odd_rows_, even_rows_;
  Matrix odd_, even_sines_;      // from values to modes
  Matrix odd_back_, even_back_;  // their transposes, times 2/N
  Vec twice_cosines_;
};

}  // namespace fde
