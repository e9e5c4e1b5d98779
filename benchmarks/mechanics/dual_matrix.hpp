// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <cstddef>
#include <type_traits>

#include "fdebench/benchmarks/mechanics/dual.hpp"

namespace fde::bench::mechanics {

template <class Entry, int rows, int columns>
class DualMatrix;

// A matrix: Eigen's for double, DualMatrix for dual numbers. A scene nests a dozen dual types, and
// instantiating Eigen's expressions for each of them is slow to compile.
template <class S, int rows, int columns>
using Table = std::conditional_t<std::is_same_v<S, double>, Eigen::Matrix<S, rows, columns>,
                                 DualMatrix<S, rows, columns>>;
template <class S, int n>
using Vector = Table<S, n, 1>;

// A small matrix of dual numbers with those functions of Eigen's matrices, under the same names, that
// mechanics needs.
template <class Entry, int rows, int columns>
class DualMatrix {
 public:
  using Scalar = Entry;
  static constexpr int RowsAtCompileTime = rows, ColsAtCompileTime = columns;

  DualMatrix() = default;
  template <class... Entries>
  requires(sizeof...(Entries) == rows && columns == 1) explicit(rows == 1)
      DualMatrix(const Entries&... entries)
      : entries_{Entry(entries)...} {}

  Entry& operator()(Eigen::Index i, Eigen::Index j) { return entries_[at(i, j)]; }
  const Entry& operator()(Eigen::Index i, Eigen::Index j) const { return entries_[at(i, j)]; }
  Entry& operator[](Eigen::Index i) { return entries_[at(i, 0)]; }
  const Entry& operator[](Eigen::Index i) const { return entries_[at(i, 0)]; }

  DualMatrix& operator+=(const DualMatrix& other) { return *this = *this + other; }
  DualMatrix& operator-=(const DualMatrix& other) { return *this = *this - other; }

  friend DualMatrix operator-(const DualMatrix& a) {
    return filled([&](int i, int j) { return -a(i, j); });
  }
  friend DualMatrix operator+(const DualMatrix& a, const DualMatrix& b) {
    return filled([&](int i, int j) { return a(i, j) + b(i, j); });
  }
  friend DualMatrix operator-(const DualMatrix& a, const DualMatrix& b) {
    return filled([&](int i, int j) { return a(i, j) - b(i, j); });
  }
  friend DualMatrix operator*(const Entry& factor, const DualMatrix& a) {
    return filled([&](int i, int j) { return factor * a(i, j); });
  }
  friend DualMatrix operator*(const DualMatrix& a, const Entry& factor) { return factor * a; }

  template <int width>
  DualMatrix<Entry, rows, width> operator*(const DualMatrix<Entry, columns, width>& b) const {
    return DualMatrix<Entry, rows, width>::filled([&](int i, int j) {
      Entry sum = (*this)(i, columns - 1) * b(columns - 1, j);
      for (int k = columns - 2; k >= 0; --k) sum = (*this)(i, k) * b(k, j) + sum;
      return sum;
    });
  }

  [[nodiscard]] DualMatrix<Entry, columns, rows> transpose() const {
    return DualMatrix<Entry, columns, rows>::filled([&](int i, int j) { return (*this)(j, i); });
  }
  [[nodiscard]] Entry dot(const DualMatrix& b) const { return (transpose() * b)[0]; }

  template <int size>
  [[nodiscard]] DualMatrix<Entry, size, 1> segment(int first) const {
    return DualMatrix<Entry, size, 1>::filled([&](int i, int) { return (*this)[first + i]; });
  }
  template <int size>
  [[nodiscard]] DualMatrix<Entry, size, 1> head() const {
    return segment<size>(0);
  }

  // d(A^-1) = -A^-1 dA A^-1.
  [[nodiscard]] DualMatrix inverse() const {
    static_assert(rows == columns);
    if constexpr (rows == 1) {
      return DualMatrix(1.0 / entries_[0]);
    } else {
      const Part inverse = part([](const Entry& entry) { return entry.value(); }).inverse();
      DualMatrix result = filled([&](int i, int j) { return Entry(inverse(i, j)); });
      for (int direction = 0; direction < Entry::directions; ++direction) {
        const Part moved = part([&](const Entry& entry) { return entry.derivative(direction); });
        const Part answer = -(inverse * Part(moved * inverse));
        for (int j = 0; j < columns; ++j) {
          for (int i = 0; i < rows; ++i) result(i, j).set_derivative(direction, answer(i, j));
        }
      }
      return result;
    }
  }

  // The matrix of entry(i, j).
  template <class Function>
  static DualMatrix filled(Function entry) {
    DualMatrix result;
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < rows; ++i) result(i, j) = entry(i, j);
    }
    return result;
  }

 private:
  using Part = Table<typename Entry::Value, rows, columns>;

  // The matrix of of(entry).
  template <class Function>
  [[nodiscard]] Part part(Function of) const {
    Part result;
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < rows; ++i) result(i, j) = of((*this)(i, j));
    }
    return result;
  }

  static std::size_t at(Eigen::Index i, Eigen::Index j) { return static_cast<std::size_t>(i + j * rows); }

  std::array<Entry, static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns)> entries_;
};

// A diagonal matrix.
template <class S, int n>
class Diagonal {
 public:
  explicit Diagonal(const Vector<S, n>& entries) : entries_(entries) {}

  operator Table<S, n, n>() const {
    Table<S, n, n> dense;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) dense(i, j) = i == j ? entries_[i] : S(0.0);
    }
    return dense;
  }
  [[nodiscard]] Diagonal inverse() const {
    Vector<S, n> inverse;
    for (int i = 0; i < n; ++i) inverse[i] = 1.0 / entries_[i];
    return Diagonal(inverse);
  }
  template <class Columns>
  [[nodiscard]] Table<S, n, Columns::ColsAtCompileTime> operator*(const Columns& x) const {
    Table<S, n, Columns::ColsAtCompileTime> result;
    for (int j = 0; j < Columns::ColsAtCompileTime; ++j) {
      for (int i = 0; i < n; ++i) result(i, j) = entries_[i] * x(i, j);
    }
    return result;
  }

 private:
  Vector<S, n> entries_;
};

}  // namespace fde::bench::mechanics
