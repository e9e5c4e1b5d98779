#pragma once

#include "problem/vectors.hpp"

namespace fde {

// The sine transform of columns of n values x_i, i = 1 ... n, with N = n + 1:
//   X_k = sum_i sin(pi i k / N) x_i,   x_i = 2/N sum_k sin(pi i k / N) X_k.
// It is made by products with the matrix of sines, halved by symmetry: modes of odd k see the sums x_i +
// x_(N-i), those of even k the differences. n/2 multiply-adds a value in a loop of full speed
// (history/block_kernels) take less time than a fast Fourier transform up to n of about 700, and for longer
// columns unless n + 1 has small factors only (docs/large.md).
class SineTransform {
 public:
  explicit SineTransform(Eigen::Index n);

  // Rows of a matrix of modes: those of odd k, then those of even k, each filled up to whole vectors by rows
  // without a mode.
  [[nodiscard]] Eigen::Index rows() const { return odd_rows_ + even_rows_; }
  [[nodiscard]] bool is_mode(Eigen::Index row) const {
    return row < odd_rows_ ? row < half_ : row - odd_rows_ < even_;
  }
  // 2 cos(pi k / N) of each row; of the first mode where a row has none.
  [[nodiscard]] const Vec& twice_cosines() const { return twice_cosines_; }

  // Of columns one after the other; modes has as many columns.
  void forward(const double* field, Matrix& modes) const;
  void backward(const Matrix& modes, double* field) const;

 private:
  Eigen::Index n_;
  Eigen::Index half_, even_;  // so many sums, and modes of odd k; so many differences, and modes of even k
  Eigen::Index odd_rows_, even_rows_;
  Matrix odd_, even_sines_;      // from values to modes
  Matrix odd_back_, even_back_;  // their transposes, times 2/N
  Vec twice_cosines_;
};

}  // namespace fde
