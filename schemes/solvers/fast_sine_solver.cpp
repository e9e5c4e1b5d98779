// SPDX-License-Identifier: MIT
#include "fdebench/schemes/solvers/fast_sine_solver.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "fdebench/schemes/history/parallel_for_rows.hpp"

namespace fde {
namespace {

// How much larger than the entries of a row the numbers may grow in its elimination without pivoting: the
// error grows by the same factor.
constexpr double most_growth = 16.0;

constexpr Eigen::Index together = 32;  // modes whose lines and pivots are in the cache together

// Values of some modes, one row a mode.
template <class Scalar>
using Panel = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

// 1 / values. The division of the standard library would take several times as long: it avoids overflow.
template <class Values>
auto reciprocals(const Values& values) {
  if constexpr (Eigen::NumTraits<typename Values::Scalar>::IsComplex) {
    return (values.conjugate() * values.abs2().inverse()).eval();
  } else {
    return values.inverse();
  }
}

// Calls work(row, count) for panels of rows of the modes.
void for_each_row_panel(const Matrix& modes, const std::function<void(Eigen::Index, Eigen::Index)>& work) {
  parallel_for_parts((modes.rows() + together - 1) / together, together * modes.cols(),
                     [&](Eigen::Index panel) {
                       work(panel * together, std::min(together, modes.rows() - panel * together));
                     });
}

// Solves with Toeplitz matrices tridiag(beside, diagonal, beside), a diagonal for each row.
template <class Scalar>
void solve_lines(const Eigen::Array<Scalar, Eigen::Dynamic, 1>& diagonal, Scalar beside,
                 Panel<Scalar>& pivots, Panel<Scalar>& x) {
  pivots.col(0) = reciprocals(diagonal);
  for (Eigen::Index j = 0; j < x.cols(); ++j) {
    if (j > 0) {
      const Eigen::Array<Scalar, Eigen::Dynamic, 1> pivot =
          diagonal - beside * beside * pivots.col(j - 1).array();
      pivots.col(j) = reciprocals(pivot);
      x.col(j) -= beside * x.col(j - 1);
    }
    x.col(j).array() *= pivots.col(j).array();
  }
  for (Eigen::Index j = x.cols() - 1; j-- > 0;)
    x.col(j).array() -= beside * pivots.col(j).array() * x.col(j + 1).array();
}

}  // namespace

// The tridiagonal matrices across the transform.
template <class Scalar>
struct FastSineSolver::Lines {
  Eigen::Array<Scalar, Eigen::Dynamic, 1> diagonals;
  Scalar off_diagonal;
};

FastSineSolver::FastSineSolver(Eigen::Index n, Eigen::Index m) : n_(n), m_(m), transform_(std::min(n, m)) {}

template <class Scalar>
FastSineSolver::Lines<Scalar> FastSineSolver::lines(const Stencil<Scalar>& stencil) const {
  const bool turned = n_ > m_;
  const Scalar transformed = turned ? stencil.cross_coupling : stencil.line_coupling;
  return {stencil.diagonal + transformed * transform_.twice_cosines().array().template cast<Scalar>(),
          turned ? stencil.line_coupling : stencil.cross_coupling};
}

template <class Scalar>
bool FastSineSolver::is_dominant(const Lines<Scalar>& lines) {
  const auto& [diagonals, beside] = lines;
  return std::isfinite(std::abs(beside)) && diagonals.isFinite().all() &&
         (diagonals.abs() >= 2.0 * std::abs(beside)).all() && (diagonals.abs() > 0.0).all();
}

bool FastSineSolver::is_stable_for(const Stencil<double>& stencil) const {
  return is_dominant(lines(stencil));
}

bool FastSineSolver::is_stable_for(const Stencil<std::complex<double>>& stencil) const {
  const auto of_lines = lines(stencil);
  if (is_dominant(of_lines)) return true;
  const auto& [diagonals, beside] = of_lines;
  const Eigen::ArrayXd largest = diagonals.abs().max(std::abs(beside));
  Eigen::ArrayXcd pivots = diagonals;
  for (Eigen::Index j = 1; j < std::max(n_, m_); ++j) {
    const Eigen::ArrayXcd eliminated = beside * beside * reciprocals(pivots);
    if (!(eliminated.abs() <= most_growth * largest).all()) return false;
    pivots = diagonals - eliminated;
  }
  return (pivots.abs() > 0.0).all();
}

int FastSineSolver::determinant_sign(const Stencil<double>& stencil) const {
  if (std::max(n_, m_) % 2 == 0) return 1;
  const auto of_lines = lines(stencil);
  int sign = 1;
  for (Eigen::Index row = 0; row < transform_.rows(); ++row) {
    if (transform_.is_mode(row) && of_lines.diagonals[row] < 0.0) sign = -sign;
  }
  return sign;
}

void FastSineSolver::forward(Vec& field, Matrix& modes) const {
  modes.resize(transform_.rows(), std::max(n_, m_));
  if (n_ > m_) {
    transposed_ = field.reshaped(n_, m_).transpose().reshaped();
    transform_.forward(transposed_.data(), modes);
  } else {
    transform_.forward(field.data(), modes);
  }
}

void FastSineSolver::backward(const Matrix& modes, Vec& field) const {
  if (n_ > m_) {
    transform_.backward(modes, transposed_.data());
    field = transposed_.reshaped(m_, n_).transpose().reshaped();
  } else {
    transform_.backward(modes, field.data());
  }
}

void FastSineSolver::solve(const Stencil<double>& stencil, Vec& b) const {
  forward(b, modes_);
  const auto of_lines = lines(stencil);
  for_each_row_panel(modes_, [&](Eigen::Index row, Eigen::Index count) {
    Panel<double> x = modes_.middleRows(row, count), pivots(count, x.cols());
    solve_lines<double>(of_lines.diagonals.segment(row, count), of_lines.off_diagonal, pivots, x);
    modes_.middleRows(row, count) = x;
  });
  backward(modes_, b);
}

void FastSineSolver::solve(const Stencil<std::complex<double>>& stencil, ComplexVec& b) const {
  real_ = b.real();
  imaginary_ = b.imag();
  forward(real_, modes_);
  forward(imaginary_, other_modes_);
  const auto of_lines = lines(stencil);
  for_each_row_panel(modes_, [&](Eigen::Index row, Eigen::Index count) {
    Panel<std::complex<double>> x(count, modes_.cols()), pivots(count, modes_.cols());
    x.real() = modes_.middleRows(row, count);
    x.imag() = other_modes_.middleRows(row, count);
    solve_lines<std::complex<double>>(of_lines.diagonals.segment(row, count), of_lines.off_diagonal, pivots,
                                      x);
    modes_.middleRows(row, count) = x.real();
    other_modes_.middleRows(row, count) = x.imag();
  });
  backward(modes_, real_);
  backward(other_modes_, imaginary_);
  b.real() = real_;
  b.imag() = imaginary_;
}

}  // namespace fde
