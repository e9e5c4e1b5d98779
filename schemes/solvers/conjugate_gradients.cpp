// SPDX-License-Identifier: MIT
#include "fdebench/schemes/solvers/conjugate_gradients.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fdebench/schemes/solvers/unit_of.hpp"

namespace fde {
namespace {

// Below, factorisation takes no longer than the iterations of one solve.
constexpr Eigen::Index fewest_unknowns = 2000;

// Nanoseconds per unknown, as measured by `fde_figures large solvers`; only their ratio is used. An iteration
// multiplies with sines of the shorter line and reads a few vectors; the cost of factors grows like the
// square root of the number of unknowns.
double iteration_cost(const FivePointMatrix& matrix) {
  return 8.0 + 0.04 * static_cast<double>(std::min(matrix.n, matrix.m));
}
double factor_cost(const FivePointMatrix& matrix) {
  return 6.0 * std::sqrt(static_cast<double>(matrix.diagonal.size()));
}

// sin(pi i / (n + 1)), i = 1 ... n.
Vec lowest_mode(Eigen::Index n) {
  const Vec numbers = Vec::LinSpaced(n, 1.0, static_cast<double>(n));
  return (std::numbers::pi / static_cast<double>(n + 1) * numbers).array().sin();
}

// The mean stencil, its diagonal such that the lowest mode has the same Rayleigh quotient as with the matrix.
Stencil<double> stencil_like(const FivePointMatrix& matrix) {
  const Vec mode = (lowest_mode(matrix.n) * lowest_mode(matrix.m).transpose()).reshaped();
  Vec product(mode.size());
  matrix.multiply(mode, product);
  Stencil<double> stencil = matrix.mean_stencil();
  const auto beside = [](double coupling, Eigen::Index n) {
    return 2.0 * coupling * std::cos(std::numbers::pi / static_cast<double>(n + 1));
  };
  stencil.diagonal = mode.dot(product) / mode.squaredNorm() - beside(stencil.line_coupling, matrix.n) -
                     beside(stencil.cross_coupling, matrix.m);
  return stencil;
}

// S M S for the diagonal s of S.
FivePointMatrix scaled(FivePointMatrix matrix, const Vec& s) {
  const Eigen::Index size = s.size(), n = matrix.n;
  matrix.diagonal.array() *= s.array().square();
  matrix.line_coupling.head(size - 1).array() *= s.head(size - 1).array() * s.tail(size - 1).array();
  matrix.cross_coupling.head(size - n).array() *= s.head(size - n).array() * s.tail(size - n).array();
  return matrix;
}

// Whether the couplings with the previous and the next point differ much anywhere on a line. For a smooth
// diffusivity they do not, after scaling.
bool jumps(const FivePointMatrix& matrix) {
  constexpr double much = 0.2;
  const auto differ = [](double one, double other) {
    return std::abs(one - other) > much * std::max(std::abs(one), std::abs(other));
  };
  const Eigen::Index size = matrix.diagonal.size(), n = matrix.n;
  for (Eigen::Index i = 0; i < size; ++i) {
    if (i % n != 0 && (i + 1) % n != 0 && differ(matrix.line_coupling[i - 1], matrix.line_coupling[i]))
      return true;
    if (i >= n && i + n < size && differ(matrix.cross_coupling[i - n], matrix.cross_coupling[i])) return true;
  }
  return false;
}

}  // namespace

bool ConjugateGradients::is_applicable(const SparseMatrix& matrix) {
  return matrix.rows() >= fewest_unknowns;
}

bool ConjugateGradients::factorise(const SparseMatrix& matrix) {
  auto found = as_five_point(matrix);
  if (!found || !found->is_diagonally_dominant() || !found->diagonal.allFinite()) return false;
  const bool same_points = sines_ && matrix_.n == found->n && matrix_.m == found->m;
  scale_ = found->diagonal.cwiseSqrt().cwiseInverse();
  matrix_ = scaled(*found, scale_);
  if (jumps(matrix_)) {
    scale_.setOnes();
    matrix_ = std::move(*found);
  }
  if (!same_points) {
    sines_ = std::make_unique<FastSineSolver>(matrix_.n, matrix_.m);
    cholesky_.reset();
  }
  stencil_ = stencil_like(matrix_);
  factorisation_cost_ = static_cast<int>(factor_cost(matrix_) / iteration_cost(matrix_));
  iterations_ = 0;
  factorised_ = false;
  return sines_->is_stable_for(stencil_);
}

void ConjugateGradients::solve(Vec& b) const {
  if (!factorised_ && iterate(b)) return;
  if (!factorised_) factorise_by_cholesky();
  b.array() *= scale_.array();
  cholesky_->solve(b);
  b.array() *= scale_.array();
}

void ConjugateGradients::factorise_by_cholesky() const {
  const SparseMatrix matrix = to_sparse(matrix_);
  if (!cholesky_) cholesky_ = std::make_unique<CholeskyFactors>(matrix);
  factorised_ = cholesky_->factorise(matrix);
}

// Replaces b by the solution. Returns false, with b unchanged, where the iterations have cost as much as
// factors.
bool ConjugateGradients::iterate(Vec& b) const {
  constexpr double rounding = 0x1p-53;
  x_ = Vec::Zero(b.size());
  const double unit = unit_of(b);
  residual_ = scale_.cwiseProduct(b / unit);
  double before = 0.0;
  for (; iterations_ < factorisation_cost_; ++iterations_) {
    preconditioned_ = residual_;
    sines_->solve(stencil_, preconditioned_);
    const double largest = scale_.cwiseProduct(preconditioned_).lpNorm<Eigen::Infinity>();
    if (!(largest > rounding * scale_.cwiseProduct(x_).lpNorm<Eigen::Infinity>())) {
      b = unit * scale_.cwiseProduct(x_);
      return true;
    }
    const double now = residual_.dot(preconditioned_);
    if (before == 0.0) {
      direction_ = preconditioned_;
    } else {
      direction_ = preconditioned_ + (now / before) * direction_;
    }
    before = now;
    matrix_.multiply(direction_, product_);
    const double length = now / direction_.dot(product_);
    x_ += length * direction_;
    residual_ -= length * product_;
  }
  return false;
}

std::string_view ConjugateGradients::active_method() const {
  return factorised_ ? cholesky_->active_method() : id;
}

void ConjugateGradients::state(Archive& archive) {
  archive.count(iterations_, 0, factorisation_cost_);
  archive(factorised_);
  if (archive.is_reading() && factorised_) factorise_by_cholesky();
}

}  // namespace fde
