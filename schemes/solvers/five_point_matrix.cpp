// SPDX-License-Identifier: MIT
#include "fdebench/schemes/solvers/five_point_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fde {
namespace {

using Entries = SparseMatrix::InnerIterator;

// n: the first point is coupled with the first point of the next line.
Eigen::Index points_of_a_line(const SparseMatrix& matrix) {
  Eigen::Index last = 0;
  for (Entries entry(matrix, 0); entry; ++entry) last = std::max<Eigen::Index>(last, entry.row());
  return last;
}

struct Ranges {
  double least = std::numeric_limits<double>::infinity(), most = -std::numeric_limits<double>::infinity();
  void add(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  [[nodiscard]] double width() const { return most - least; }
  [[nodiscard]] double middle() const { return least + width() / 2.0; }
};

}  // namespace

Stencil<double> FivePointMatrix::mean_stencil() const {
  return {diagonal.mean(), line_coupling.sum() / static_cast<double>((n - 1) * m),
          cross_coupling.sum() / static_cast<double>(n * (m - 1))};
}

std::optional<Stencil<double>> FivePointMatrix::constant_stencil() const {
  constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon();
  const double most = rounding * diagonal.cwiseAbs().maxCoeff();
  Ranges own, of_line, of_next;
  for (Eigen::Index i = 0; i < diagonal.size(); ++i) {
    own.add(diagonal[i]);
    if ((i + 1) % n != 0) of_line.add(line_coupling[i]);
    if (i + n < diagonal.size()) of_next.add(cross_coupling[i]);
  }
  if (!(own.width() <= most && of_line.width() <= most && of_next.width() <= most)) return std::nullopt;
  return Stencil<double>{own.middle(), of_line.middle(), of_next.middle()};
}

bool FivePointMatrix::is_diagonally_dominant() const {
  const Eigen::Index size = diagonal.size();
  for (Eigen::Index i = 0; i < size; ++i) {
    const double before =
        (i > 0 ? std::abs(line_coupling[i - 1]) : 0.0) + (i >= n ? std::abs(cross_coupling[i - n]) : 0.0);
    if (!(diagonal[i] > before + std::abs(line_coupling[i]) + std::abs(cross_coupling[i]))) return false;
  }
  return true;
}

void FivePointMatrix::multiply(const Vec& x, Vec& y) const {
  const Eigen::Index size = x.size();
  y = diagonal.cwiseProduct(x);
  y.head(size - 1) += line_coupling.head(size - 1).cwiseProduct(x.tail(size - 1));
  y.tail(size - 1) += line_coupling.head(size - 1).cwiseProduct(x.head(size - 1));
  y.head(size - n) += cross_coupling.head(size - n).cwiseProduct(x.tail(size - n));
  y.tail(size - n) += cross_coupling.head(size - n).cwiseProduct(x.head(size - n));
}

std::optional<FivePointMatrix> as_five_point(const SparseMatrix& matrix) {
  const Eigen::Index size = matrix.rows(), n = size > 0 ? points_of_a_line(matrix) : 0;
  if (n < 2 || size % n != 0 || size / n < 2) return std::nullopt;
  FivePointMatrix found{n, size / n, Vec::Zero(size), Vec::Zero(size), Vec::Zero(size)};
  for (Eigen::Index j = 0; j < size; ++j) {
    double before = 0.0, line_before = 0.0;
    for (Entries entry(matrix, j); entry; ++entry) {
      const Eigen::Index offset = entry.row() - j;
      const double value = entry.value();
      if (offset == n) {
        found.cross_coupling[j] = value;
      } else if (offset == -n) {
        line_before = value;
      } else if (offset == 0) {
        found.diagonal[j] = value;
      } else if (offset == 1 && (j + 1) % n != 0) {
        found.line_coupling[j] = value;
      } else if (offset == -1 && j % n != 0) {
        before = value;
      } else if (value != 0.0) {
        return std::nullopt;
      }
    }
    const bool symmetric = before == (j > 0 ? found.line_coupling[j - 1] : 0.0) &&
                           line_before == (j >= n ? found.cross_coupling[j - n] : 0.0);
    if (!symmetric) return std::nullopt;
  }
  return found;
}

SparseMatrix to_sparse(const FivePointMatrix& matrix) {
  const Eigen::Index size = matrix.diagonal.size(), n = matrix.n;
  SparseMatrix result(size, size);
  result.reserve(Eigen::VectorXi::Constant(static_cast<int>(size), 5));
  for (Eigen::Index j = 0; j < size; ++j) {
    if (j >= n) result.insert(j - n, j) = matrix.cross_coupling[j - n];
    if (j % n != 0) result.insert(j - 1, j) = matrix.line_coupling[j - 1];
    result.insert(j, j) = matrix.diagonal[j];
    if ((j + 1) % n != 0) result.insert(j + 1, j) = matrix.line_coupling[j];
    if (j + n < size) result.insert(j + n, j) = matrix.cross_coupling[j];
  }
  result.makeCompressed();
  return result;
}

}  // namespace fde
