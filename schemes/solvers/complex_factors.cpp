// SPDX-License-Identifier: MIT
#include "fdebench/schemes/solvers/complex_factors.hpp"

#include <Eigen/SparseLU>
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

template <class Method>
std::unique_ptr<ComplexFactors> factors_by(const SparseMatrix& matrix, Complex factor) {
  auto factors = std::make_unique<Method>();
  return factors->factorise(matrix, factor) ? std::move(factors) : nullptr;
}

}  // namespace

std::unique_ptr<ComplexFactors> complex_factors(const SparseMatrix& matrix, Complex factor) {
  if (auto factors = factors_by<ComplexTridiagonal>(matrix, factor)) return factors;
  if (auto factors = factors_by<ComplexFastSine>(matrix, factor)) return factors;
  return factors_by<ComplexLu>(matrix, factor);
}

}  // namespace fde
