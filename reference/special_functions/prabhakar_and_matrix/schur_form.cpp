// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/prabhakar_and_matrix/schur_form.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/multiprecision/eigen.hpp>
#include <numeric>
#include <stdexcept>

#include "fdebench/reference/special_functions/numbers/constants.hpp"

namespace fde::reference {
namespace {

using Long = long double;
using WideMatrix = Eigen::Matrix<BigReal, Eigen::Dynamic, Eigen::Dynamic>;

// The rows and columns reordered so that a matrix which is block triangular in some order is block upper
// triangular: those that row i reaches through nonzero entries, without being reached by them, come after it.
// Then the eigenvalues of a triangular matrix are its diagonal, however often they are repeated.
WideMatrix in_block_order(const WideMatrix& matrix) {
  const Eigen::Index n = matrix.rows();
  Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic> reaches =
      matrix.unaryExpr([](const BigReal& x) { return x != 0; });
  for (Eigen::Index k = 0; k < n; ++k) reaches(k, k) = true;
  for (Eigen::Index k = 0; k < n; ++k) {
    for (Eigen::Index i = 0; i < n; ++i)
      if (reaches(i, k)) reaches.row(i) = reaches.row(i).array() || reaches.row(k).array();
  }
  // Who reaches more comes first; rows that reach each other reach the same and stay together.
  std::vector<Eigen::Index> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::ranges::stable_sort(order, [&](Eigen::Index a, Eigen::Index b) {
    const auto first = reaches.row(a).count(), second = reaches.row(b).count();
    if (first != second) return first > second;
    return std::lexicographical_compare(reaches.row(a).begin(), reaches.row(a).end(), reaches.row(b).begin(),
                                        reaches.row(b).end());
  });
  return matrix(order, order);
}

// A + iB as the real matrix [A -B; B A], or A if B = 0.
WideMatrix as_real(const BigMatrix& matrix) {
  const int n = matrix.size, size = matrix.real() ? n : 2 * n;
  WideMatrix real(size, size);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const auto re = real_part<BigReal>(matrix(i, j));
      real(i, j) = re;
      if (size == n) continue;
      const auto im = imag_part<BigReal>(matrix(i, j));
      real(n + i, n + j) = re;
      real(n + i, j) = im;
      real(i, n + j) = -im;
    }
  }
  return real;
}

SchurForm::Point log_of(const BigReal& re, const BigReal& im) {
  constexpr Long log_of_zero = -11000.0L;
  const BigReal square = re * re + im * im;
  if (square == 0) return log_of_zero;
  return {BigReal(log(square) / 2).convert_to<Long>(), BigReal(atan2(im, re)).convert_to<Long>()};
}

SchurForm::Point long_point(const BigReal& re, const BigReal& im) {
  return {re.convert_to<Long>(), im.convert_to<Long>()};
}

}  // namespace

SchurForm::SchurForm(const BigMatrix& matrix) {
  // Next to a multiple eigenvalue the iteration gains few digits a step.
  const Eigen::Index most_steps =
      40 * static_cast<Eigen::Index>(matrix.size) * static_cast<Eigen::Index>(BigReal::default_precision());
  Eigen::RealSchur<WideMatrix> schur(2 * static_cast<Eigen::Index>(matrix.size));
  schur.setMaxIterations(most_steps);
  schur.compute(in_block_order(as_real(matrix)), false);
  if (schur.info() != Eigen::Success)
    throw std::runtime_error("the iteration for the eigenvalues did not converge");
  const WideMatrix& t = schur.matrixT();
  const auto size = static_cast<int>(t.rows());
  sizes_ = t.cwiseAbs().unaryExpr([](const BigReal& x) { return x.convert_to<Long>(); });
  for (int i = 0; i < size;) {
    const bool pair = i + 1 < size && t(i + 1, i) != 0;
    if (!pair) {
      blocks_.push_back(
          {i, 1, {long_point(t(i, i), BigReal(0)), 0.0L}, {long_point(t(i, i), BigReal(0)), 0.0L}});
      log_eigenvalues_.push_back(log_of(t(i, i), BigReal(0)));
      ++i;
      continue;
    }
    const BigReal mean = (t(i, i) + t(i + 1, i + 1)) / 2, half = (t(i, i) - t(i + 1, i + 1)) / 2;
    const BigReal square = half * half + t(i, i + 1) * t(i + 1, i), root = sqrt(BigReal(abs(square)));
    const bool real = square >= 0;
    const BigReal first = real ? BigReal(mean + root) : mean, second = real ? BigReal(mean - root) : mean;
    const BigReal im = real ? BigReal(0) : root;
    blocks_.push_back({i,
                       2,
                       {long_point(first, im), long_point(second, -im)},
                       {long_point(t(i, i), BigReal(0)), long_point(t(i + 1, i + 1), BigReal(0))}});
    log_eigenvalues_.push_back(log_of(first, im));
    log_eigenvalues_.push_back(log_of(second, -im));
    i += 2;
  }
}

// Entrywise bound of the resolvent of a diagonal block on the disc: for two rows
// [z - d, b; c, z - a] / ((z - first) (z - second)). All later operations add nonnegative numbers.
std::optional<Eigen::Matrix<Long, 2, 2>> SchurForm::block_resolvent(const Block& block, const Point& z,
                                                                    Long radius) const {
  constexpr Long rounding = 1e-16L;
  Long least = 1.0L;
  for (int k = 0; k < block.rows; ++k) {
    const Point& eigenvalue = block.eigenvalues[static_cast<std::size_t>(k)];
    const Long distance = std::abs(z - eigenvalue) - radius - rounding * (std::abs(z) + std::abs(eigenvalue));
    if (!(distance > 0.0L)) return std::nullopt;
    least *= distance;
  }
  Eigen::Matrix<Long, 2, 2> bound = Eigen::Matrix<Long, 2, 2>::Zero();
  if (block.rows == 1) {
    bound(0, 0) = 1.0L / least;
    return bound;
  }
  bound << std::abs(z - block.diagonal[1]) + radius, sizes_(block.first, block.first + 1),
      sizes_(block.first + 1, block.first), std::abs(z - block.diagonal[0]) + radius;
  return bound / least;
}

// With B the inverse of the bounds in blocks, nonnegative: row sums B 1 from below, column sums 1 B from
// above.
long double SchurForm::resolvent_norm(const Point& z, long double radius) const {
  const auto size = sizes_.rows();
  LongVector row_sums = LongVector::Zero(size), column_sums = row_sums;
  std::vector<Eigen::Matrix<Long, 2, 2>> diagonals;
  for (const Block& block : blocks_) {
    const auto diagonal = block_resolvent(block, z, radius);
    if (!diagonal) return infinity_long;
    diagonals.push_back(*diagonal);
    const auto rows = block.rows, first = block.first;
    const LongVector above =
        sizes_.topRows(first).middleCols(first, rows).transpose() * column_sums.head(first) +
        LongVector::Ones(rows);
    column_sums.segment(first, rows) = diagonal->topLeftCorner(rows, rows).transpose() * above;
  }
  for (std::size_t k = blocks_.size(); k-- > 0;) {
    const auto rows = blocks_[k].rows, first = blocks_[k].first;
    const auto rest = size - first - rows;
    const LongVector right =
        sizes_.block(first, first + rows, rows, rest) * row_sums.tail(rest) + LongVector::Ones(rows);
    row_sums.segment(first, rows) = diagonals[k].topLeftCorner(rows, rows) * right;
  }
  constexpr Long rounding = 1.0L + 1e-12L;
  return std::sqrt(row_sums.maxCoeff() * column_sums.maxCoeff()) * rounding;
}

}  // namespace fde::reference
