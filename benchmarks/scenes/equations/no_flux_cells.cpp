// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/equations/no_flux_cells.hpp"

#include <algorithm>
#include <array>

namespace fde::bench {

NoFluxCells::NoFluxCells(FieldShape shape, double coupling)
    : shape_(shape), coupling_(coupling * shape.points * shape.points) {}

Vec NoFluxCells::midpoints() const {
  const double n = shape_.points;
  return Vec::LinSpaced(shape_.points, 0.5 / n, (n - 0.5) / n);
}

void NoFluxCells::apply_laplacian(In u, Out f) const {
  const Eigen::Index n = shape_.points, lines = shape_.size() / n;
  // Adds the flux between each of `count` cells and the cell `apart` indices further on.
  const auto exchange = [&](Eigen::Index first, Eigen::Index count, Eigen::Index apart) {
    const auto here = u.segment(first, count), there = u.segment(first + apart, count);
    f.segment(first, count) += coupling_ * (there - here);
    f.segment(first + apart, count) -= coupling_ * (there - here);
  };
  f.setZero();
  for (Eigen::Index j = 0; j < lines; ++j) {
    exchange(j * n, n - 1, 1);
    if (j + 1 < lines) exchange(j * n, n, n);
  }
}

SparseMatrix NoFluxCells::matrix() const {
  const Eigen::Index n = shape_.points, size = shape_.size();
  SparseMatrix result(size, size);
  result.reserve(Eigen::VectorXi::Constant(static_cast<int>(size), 2 * shape_.dimensions + 1));
  for (Eigen::Index place = 0; place < size; ++place) {
    const bool left = place % n > 0, right = place % n + 1 < n, below = place >= n, above = place + n < size;
    const std::array<bool, 4> sides{left, right, below, above};
    if (below) result.insert(place - n, place) = coupling_;
    if (left) result.insert(place - 1, place) = coupling_;
    result.insert(place, place) = -coupling_ * static_cast<double>(std::ranges::count(sides, true));
    if (right) result.insert(place + 1, place) = coupling_;
    if (above) result.insert(place + n, place) = coupling_;
  }
  result.makeCompressed();
  return result;
}

}  // namespace fde::bench
