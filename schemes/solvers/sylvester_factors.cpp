// SPDX-License-Identifier: MIT
#include "fdebench/schemes/solvers/sylvester_factors.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <utility>

namespace fde {

bool SylvesterFactors::factorise(const SparseMatrix& a, const Matrix& k, double scale, double accuracy) {
  a_ = &a;
  if (k_.rows() != k.rows() || k_ != k) {
    const Eigen::RealSchur<Matrix> schur(k.transpose());
    k_ = k;
    q_ = schur.matrixU();
    schur_ = schur.matrixT();
  }
  t_ = scale * schur_;
  blocks_.clear();
  for (Eigen::Index c = 0; c < t_.cols(); ++c) {
    const bool pair = c + 1 < t_.cols() && t_(c + 1, c) != 0.0;
    if (!(pair ? add_pair(t_.block<2, 2>(c, c), accuracy) : add_real(t_(c, c)))) return false;
    if (pair) ++c;
  }
  return true;
}

bool SylvesterFactors::add_real(double eigenvalue) {
  SparseMatrix matrix(a_->rows(), a_->cols());
  matrix.setIdentity();
  matrix -= eigenvalue * *a_;
  matrix.makeCompressed();
  auto factors = sparse_factors(matrix);
  if (factors == nullptr) return false;
  blocks_.emplace_back(std::move(factors));
  return true;
}

// For the eigenvalue l = m + i w of ((a, b), (c, d)) above the real axis q = (b, l - a), and the first row of
// (q, q*)^-1 is (q2*, -b) / (-2 i b w); b c < 0.
bool SylvesterFactors::add_pair(const Eigen::Matrix2d& block, double accuracy) {
  const double b = block(0, 1), half = 0.5 * (block(0, 0) - block(1, 1));
  const double w = std::sqrt(std::abs(half * half + b * block(1, 0)));
  const std::complex<double> l{block(0, 0) - half, w}, scale{0.0, -2.0 * b * w};
  const Eigen::Vector2cd q{b, l - block(0, 0)};
  Pair pair{complex_factors(*a_, l, accuracy), q, Eigen::RowVector2cd{std::conj(q[1]) / scale, -b / scale}};
  if (pair.factors == nullptr) return false;
  blocks_.emplace_back(std::move(pair));
  return true;
}

int SylvesterFactors::determinant_sign() const {
  int sign = 1;
  for (const auto& block : blocks_) {
    if (const auto* real = std::get_if<0>(&block)) sign *= (*real)->determinant_sign();
  }
  return sign;
}

void SylvesterFactors::solve(Vec& b) const {
  auto z = b.reshaped(a_->rows(), t_.cols());
  z = (z * q_).eval();
  Eigen::Index c = 0;
  for (const auto& block : blocks_) {
    const Eigen::Index width = std::holds_alternative<Pair>(block) ? 2 : 1;
    auto columns = z.middleCols(c, width);
    if (c > 0) columns += *a_ * (z.leftCols(c) * t_.block(0, c, c, width)).eval();
    if (const auto* real = std::get_if<0>(&block)) {
      Vec column = columns;
      (*real)->solve(column);
      columns = column;
    } else {
      const auto& [factors, q, p] = std::get<Pair>(block);
      ComplexVec pair(columns.rows());
      pair.real() = columns * q.real();
      pair.imag() = columns * q.imag();
      factors->solve(pair);
      columns = 2.0 * (pair.real() * p.real() - pair.imag() * p.imag());
    }
    c += width;
  }
  z = (z * q_.transpose()).eval();
}

std::string_view SylvesterFactors::method() const {
  std::string_view method;
  for (const auto& block : blocks_) {
    if (const auto* pair = std::get_if<Pair>(&block)) return pair->factors->name();
    method = std::get<0>(block)->active_method();
  }
  return method;
}

}  // namespace fde
