// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/prabhakar_and_matrix/resolvent.hpp"

namespace fde::reference {
namespace {

BigMatrix identity(int size) {
  BigMatrix unit{size, {}};
  unit.entries.assign(unit.index(size, 0), BigComplex(0));
  for (int i = 0; i < size; ++i) unit(i, i) = BigComplex(1);
  return unit;
}

void swap_rows(BigMatrix& matrix, int a, int b) {
  for (int j = 0; a != b && j < matrix.size; ++j) std::swap(matrix(a, j), matrix(b, j));
}

int pivot_of(const BigMatrix& matrix, int column) {
  int best = column;
  for (int i = column + 1; i < matrix.size; ++i) {
    if (norm1(matrix(i, column)) > norm1(matrix(best, column))) best = i;
  }
  return best;
}

// row a -= factor * row b
void subtract_row(BigMatrix& matrix, int a, int b, const BigComplex& factor) {
  for (int j = 0; j < matrix.size; ++j) {
    if (matrix(b, j) != 0) matrix(a, j) -= factor * matrix(b, j);
  }
}

// By Gauss-Jordan elimination with partial pivoting; the result for a singular matrix is not finite.
BigMatrix inverse(BigMatrix matrix) {
  BigMatrix result = identity(matrix.size);
  for (int k = 0; k < matrix.size; ++k) {
    const int pivot = pivot_of(matrix, k);
    swap_rows(matrix, k, pivot);
    swap_rows(result, k, pivot);
    const BigComplex scale = BigReal(1) / matrix(k, k);
    for (int j = 0; j < matrix.size; ++j) {
      matrix(k, j) *= scale;
      result(k, j) *= scale;
    }
    for (int i = 0; i < matrix.size; ++i) {
      const BigComplex factor = matrix(i, k);
      if (i == k || factor == 0) continue;
      subtract_row(matrix, i, k, factor);
      subtract_row(result, i, k, factor);
    }
  }
  return result;
}

// The row norm of I - M X, including the rounding of its evaluation.
BigReal residual_norm(const BigMatrix& matrix, const BigMatrix& inverse) {
  BigReal largest(0);
  for (int i = 0; i < matrix.size; ++i) {
    BigReal row(0);
    for (int j = 0; j < matrix.size; ++j) {
      BigComplex sum(i == j ? 1 : 0);
      BigReal size(1);
      for (int k = 0; k < matrix.size; ++k) {
        sum -= matrix(i, k) * inverse(k, j);
        size += norm1(matrix(i, k)) * norm1(inverse(k, j));
      }
      row += norm1(sum) + (4 + matrix.size) * epsilon<BigReal>() * size;
    }
    largest = std::max(largest, row);
  }
  return largest;
}

// Maximum row sum of norm1(entry).
BigReal row_norm(const BigMatrix& matrix) {
  BigReal largest(0);
  for (int i = 0; i < matrix.size; ++i) {
    BigReal row(0);
    for (int j = 0; j < matrix.size; ++j) row += norm1(matrix(i, j));
    largest = std::max(largest, row);
  }
  return largest;
}

}  // namespace

BoundedInverse bounded_inverse(const BigMatrix& matrix) {
  BoundedInverse result{.value = inverse(matrix), .norm = BigReal(0), .bound = BigReal(0)};
  const BigReal residual = residual_norm(matrix, result.value);
  result.norm = row_norm(result.value);
  result.bound = residual < 1 ? BigReal(result.norm * residual / (1 - residual))
                              : BigReal(std::numeric_limits<double>::infinity());
  return result;
}

}  // namespace fde::reference
