// SPDX-License-Identifier: MIT
#include "fdebench/schemes/solvers/complex_factors.hpp"

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "fdebench/schemes/solvers/fast_sine_solver.hpp"
#include "fdebench/schemes/solvers/tridiagonal.hpp"

namespace fde {
namespace {

using Complex = std::complex<double>;
using ComplexSparse = Eigen::SparseMatrix<Complex>;

ComplexSparse one_minus(const SparseMatrix& matrix, Complex factor) {
  ComplexSparse one(matrix.rows(), matrix.cols());
  one.setIdentity();
  return one - factor * matrix.cast<Complex>();
}

class ComplexTridiagonal final : public ComplexFactors {
 public:
  bool factorise(const SparseMatrix& matrix, Complex factor) override {
    return TridiagonalLu<double>::is_applicable(matrix) && factors_.factorise(one_minus(matrix, factor));
  }
  void solve(ComplexVec& b) const override { factors_.solve(b); }
  [[nodiscard]] std::string_view name() const override { return "tridiagonal"; }

 private:
  TridiagonalLu<Complex> factors_;
};

class ComplexFastSine final : public ComplexFactors {
 public:
  bool factorise(const SparseMatrix& matrix, Complex factor) override {
    const auto found = as_five_point(matrix);
    const auto stencil = found ? found->constant_stencil() : std::nullopt;
    if (!stencil) return false;
    if (!sines_) sines_.emplace(found->n, found->m);
    stencil_ = {1.0 - factor * stencil->diagonal, -factor * stencil->line_coupling,
                -factor * stencil->cross_coupling};
    return sines_->is_stable_for(stencil_);
  }
  void solve(ComplexVec& b) const override { sines_->solve(stencil_, b); }
  [[nodiscard]] std::string_view name() const override { return "fast_sine"; }

 private:
  std::optional<FastSineSolver> sines_{};
  Stencil<Complex> stencil_{};
};

class ComplexLu final : public ComplexFactors {
 public:
  bool factorise(const SparseMatrix& matrix, Complex factor) override {
    if (!matrix.coeffs().allFinite()) return false;
    factors_.compute(one_minus(matrix, factor));
    return factors_.info() == Eigen::Success;
  }
  void solve(ComplexVec& b) const override { b = factors_.solve(b).eval(); }
  [[nodiscard]] std::string_view name() const override { return "lu"; }

 private:
  Eigen::SparseLU<ComplexSparse> factors_;
};

// Conjugate gradients for complex symmetric matrices, with products x^T y (van der Vorst & Melissen, IEEE
// Trans. Magn. 26 (1990)), preconditioned by FastSineSolver with the mean stencil. Iterations end as those of
// ConjugateGradients. When those for one matrix have cost about as much as LU, LU solves from then on.
class ComplexConjugateGradients final : public ComplexFactors {
 public:
  bool factorise(const SparseMatrix& matrix, Complex factor) override {
    constexpr Eigen::Index fewest_unknowns = 2000;  // below, LU takes no longer
    if (matrix.rows() < fewest_unknowns) return false;
    auto found = as_five_point(matrix);
    if (!found || !found->diagonal.allFinite()) return false;
    if (!sines_) sines_.emplace(found->n, found->m);
    matrix_ = std::move(*found);
    factor_ = factor;
    lu_.reset();
    iterations_ = 0;
    // Nanoseconds an unknown of LU, and of an iteration, as in ConjugateGradients.
    const auto lines = static_cast<double>(std::min(matrix_.n, matrix_.m));
    most_iterations_ =
        static_cast<int>(72.0 * std::sqrt(static_cast<double>(matrix.rows())) / (32.0 + 0.16 * lines));
    const auto mean = matrix_.mean_stencil();
    stencil_ = {1.0 - factor * mean.diagonal, -factor * mean.line_coupling, -factor * mean.cross_coupling};
    return sines_->is_stable_for(stencil_);
  }

  void solve(ComplexVec& b) const override {
    if (!lu_ && iterate(b)) return;
    if (!lu_) {
      lu_ = std::make_unique<ComplexLu>();
      solvable_ = lu_->factorise(to_sparse(matrix_), factor_);
    }
    if (solvable_) {
      lu_->solve(b);
    } else {
      b.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
  }

  [[nodiscard]] std::string_view name() const override { return lu_ ? lu_->name() : "conjugate_gradients"; }

 private:
  // Replaces b by the solution. Returns false, with b unchanged, where iterations have cost as much as LU.
  bool iterate(ComplexVec& b) const {
    constexpr double rounding = 0x1p-53;
    ComplexVec x = ComplexVec::Zero(b.size()), residual = b, direction, product;
    Complex before = 0.0;
    for (bool first = true; iterations_ < most_iterations_; ++iterations_, first = false) {
      ComplexVec preconditioned = residual;
      sines_->solve(stencil_, preconditioned);
      const double largest = preconditioned.lpNorm<Eigen::Infinity>();
      if (!(largest > rounding * x.lpNorm<Eigen::Infinity>())) {
        b = x;
        return true;
      }
      const Complex now = (residual.transpose() * preconditioned).value();
      direction = first ? preconditioned : ComplexVec(preconditioned + (now / before) * direction);
      before = now;
      multiply(direction, product);
      const Complex length = now / (direction.transpose() * product).value();
      x += length * direction;
      residual -= length * product;
    }
    return false;
  }

  // Sets y to (1 - factor A) x.
  void multiply(const ComplexVec& x, ComplexVec& y) const {
    Vec real(x.size()), imaginary(x.size());
    matrix_.multiply(x.real(), real);
    matrix_.multiply(x.imag(), imaginary);
    y.resize(x.size());
    y.real() = real;
    y.imag() = imaginary;
    y = x - factor_ * y;
  }

  std::optional<FastSineSolver> sines_{};
  FivePointMatrix matrix_{};
  Complex factor_ = 0.0;
  Stencil<Complex> stencil_{};
  int most_iterations_ = 0;
  mutable int iterations_ = 0;  // of all solves
  mutable std::unique_ptr<ComplexLu> lu_;
  mutable bool solvable_ = false;
};

template <class Method>
std::unique_ptr<ComplexFactors> factors_by(const SparseMatrix& matrix, Complex factor) {
  auto factors = std::make_unique<Method>();
  return factors->factorise(matrix, factor) ? std::move(factors) : nullptr;
}

}  // namespace

std::unique_ptr<ComplexFactors> complex_factors(const SparseMatrix& matrix, Complex factor) {
  if (auto factors = factors_by<ComplexTridiagonal>(matrix, factor)) return factors;
  if (auto factors = factors_by<ComplexFastSine>(matrix, factor)) return factors;
  if (auto factors = factors_by<ComplexConjugateGradients>(matrix, factor)) return factors;
  return factors_by<ComplexLu>(matrix, factor);
}

}  // namespace fde
