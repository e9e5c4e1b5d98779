// SPDX-License-Identifier: MIT
#include "fdebench/schemes/solvers/sparse_factors.hpp"

#include <optional>
#include <utility>

#include "fdebench/schemes/solvers/cholesky_factors.hpp"
#include "fdebench/schemes/solvers/conjugate_gradients.hpp"
#include "fdebench/schemes/solvers/fast_sine_solver.hpp"
#include "fdebench/schemes/solvers/sparse_lu.hpp"
#include "fdebench/schemes/solvers/tridiagonal.hpp"

template class Eigen::SparseLU<fde::SparseMatrix>;

namespace fde {
namespace {

class TridiagonalFactors final : public SparseFactors {
 public:
  static constexpr std::string_view id = "tridiagonal";

  explicit TridiagonalFactors(const SparseMatrix& /*matrix*/) {}

  static bool is_applicable(const SparseMatrix& matrix) {
    return TridiagonalLu<double>::is_applicable(matrix);
  }
  bool factorise(const SparseMatrix& matrix) override { return factors_.factorise(matrix); }
  [[nodiscard]] int determinant_sign() override { return factors_.determinant_sign(); }
  void solve(Vec& b) const override { factors_.solve(b); }
  [[nodiscard]] std::string_view active_method() const override { return id; }

 private:
  TridiagonalLu<double> factors_;
};

class FastSineFactors final : public SparseFactors {
 public:
  static constexpr std::string_view id = "fast_sine";

  explicit FastSineFactors(const SparseMatrix& /*matrix*/) {}

  static bool is_applicable(const SparseMatrix& /*matrix*/) { return true; }

  bool factorise(const SparseMatrix& matrix) override {
    const auto found = as_five_point(matrix);
    const auto stencil = found ? found->constant_stencil() : std::nullopt;
    if (!stencil) return false;
    // The pattern is the same in every call.
    if (!sines_) sines_.emplace(found->n, found->m);
    stencil_ = *stencil;
    return sines_->is_stable_for(stencil_);
  }

  [[nodiscard]] int determinant_sign() override { return sines_->determinant_sign(stencil_); }
  void solve(Vec& b) const override { sines_->solve(stencil_, b); }
  [[nodiscard]] std::string_view active_method() const override { return id; }

 private:
  std::optional<FastSineSolver> sines_;
  Stencil<double> stencil_{};
};

class LuFactors final : public SparseFactors {
 public:
  static constexpr std::string_view id = "lu";

  explicit LuFactors(const SparseMatrix& matrix) { factors_.analyzePattern(matrix); }

  static bool is_applicable(const SparseMatrix& /*matrix*/) { return true; }

  bool factorise(const SparseMatrix& matrix) override {
    if (!matrix.coeffs().allFinite()) return false;
    factors_.factorize(matrix);
    return factors_.info() == Eigen::Success;
  }

  [[nodiscard]] int determinant_sign() override { return static_cast<int>(factors_.signDeterminant()); }
  void solve(Vec& b) const override { b = factors_.solve(b).eval(); }
  [[nodiscard]] std::string_view active_method() const override { return id; }

 private:
  SparseLu factors_;
};

template <class Method>
std::unique_ptr<SparseFactors> factors_by(const SparseMatrix& matrix, std::string_view method) {
  if (!(method.empty() || method == Method::id) || !Method::is_applicable(matrix)) return nullptr;
  auto factors = std::make_unique<Method>(matrix);
  return factors->factorise(matrix) ? std::move(factors) : nullptr;
}

}  // namespace

std::unique_ptr<SparseFactors> sparse_factors(const SparseMatrix& matrix, std::string_view method) {
  if (auto factors = factors_by<TridiagonalFactors>(matrix, method)) return factors;
  if (auto factors = factors_by<FastSineFactors>(matrix, method)) return factors;
  if (auto factors = factors_by<ConjugateGradients>(matrix, method)) return factors;
  if (auto factors = factors_by<CholeskyFactors>(matrix, method)) return factors;
  return factors_by<LuFactors>(matrix, method);
}

}  // namespace fde
