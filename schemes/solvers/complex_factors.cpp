// SPDX-License-Identifier: MIT
#include "fdebench/schemes/solvers/complex_factors.hpp"

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "fdebench/schemes/solvers/cholesky_factors.hpp"
#include "fdebench/schemes/solvers/fast_sine_solver.hpp"
#include "fdebench/schemes/solvers/tridiagonal.hpp"
#include "fdebench/schemes/solvers/unit_of.hpp"

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

template <class Method, class... Settings>
std::unique_ptr<ComplexFactors> factors_by(const SparseMatrix& matrix, Complex factor, Settings... settings) {
  auto factors = std::make_unique<Method>(settings...);
  return factors->factorise(matrix, factor) ? std::move(factors) : nullptr;
}

double largest_size(const ComplexVec& x) { return std::sqrt(x.cwiseAbs2().maxCoeff()); }

// Conjugate gradients for a complex symmetric matrix, with products x^T y (van der Vorst & Melissen, IEEE
// Trans. Magn. 26 (1990)), until the preconditioned residual is below `accuracy` times the solution. nullopt:
// `left`, the number of iterations that are left, has become 0.
template <class Multiply, class Precondition>
std::optional<ComplexVec> by_conjugate_gradients(const ComplexVec& b, const Multiply& multiply,
                                                 const Precondition& precondition, double accuracy,
                                                 int& left) {
  ComplexVec x = ComplexVec::Zero(b.size()), residual = b, direction;
  Complex before = 0.0;
  for (bool first = true; left > 0; --left, first = false) {
    ComplexVec preconditioned = residual;
    precondition(preconditioned);
    if (!(largest_size(preconditioned) > accuracy * largest_size(x))) return x;
    const Complex now = (residual.transpose() * preconditioned).value();
    direction = first ? preconditioned : ComplexVec(preconditioned + (now / before) * direction);
    before = now;
    const ComplexVec product = multiply(direction);
    const Complex length = now / (direction.transpose() * product).value();
    x += length * direction;
    residual -= length * product;
  }
  return std::nullopt;
}

// A method whose iterations may end without the solution: another one solves from then on.
class ComplexIterations : public ComplexFactors {
 public:
  explicit ComplexIterations(double accuracy) : accuracy_(accuracy) {}

  void solve(ComplexVec& b) const final {
    if (!other_) {
      const double unit = unit_of(b);
      if (const auto x = iterate(b / unit)) {
        b = unit * *x;
        return;
      }
      other_ = instead();
    }
    if (other_) {
      other_->solve(b);
    } else {
      b.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
  }
  [[nodiscard]] std::string_view name() const final { return other_ ? other_->name() : method(); }

 protected:
  // The solution; nullopt: iterations have cost too much.
  [[nodiscard]] virtual std::optional<ComplexVec> iterate(const ComplexVec& b) const = 0;
  // What solves instead; nullptr: nothing does.
  [[nodiscard]] virtual std::unique_ptr<ComplexFactors> instead() const = 0;
  [[nodiscard]] virtual std::string_view method() const = 0;

  void begin() { other_.reset(); }
  [[nodiscard]] double accuracy() const { return accuracy_; }

 private:
  const double accuracy_;
  mutable std::unique_ptr<ComplexFactors> other_;
};

// Conjugate gradients preconditioned by the real factors of 1 - |factor| A, for symmetric A. With eigenvalues
// of A below 0 those of the preconditioned matrix are between 1 and the direction of the factor, so a few
// iterations suffice.
class ComplexCholesky final : public ComplexIterations {
 public:
  using ComplexIterations::ComplexIterations;
  bool factorise(const SparseMatrix& matrix, Complex factor) override {
    // With fewer unknowns or entries LU takes no longer, with more unknowns conjugate gradients with sines.
    constexpr Eigen::Index fewest_unknowns = 1000, most_unknowns = 300'000, entries_of_a_line = 3;
    if (matrix.rows() < fewest_unknowns || matrix.rows() > most_unknowns ||
        matrix.nonZeros() <= entries_of_a_line * matrix.rows() || !matrix.coeffs().allFinite() ||
        !CholeskyFactors::is_applicable(matrix))
      return false;
    begin();
    matrix_ = matrix;
    factor_ = factor;
    SparseMatrix real(matrix.rows(), matrix.cols());
    real.setIdentity();
    real -= std::abs(factor) * matrix;
    real.makeCompressed();
    factors_.emplace(real);
    return factors_->factorise(real);
  }

 protected:
  [[nodiscard]] std::optional<ComplexVec> iterate(const ComplexVec& b) const override {
    int left = 60;  // as many take no less time than LU
    const auto precondition = [&](ComplexVec& x) { factors_->solve(x); };
    const auto multiply = [&](const ComplexVec& x) { return ComplexVec(x - factor_ * (matrix_ * x)); };
    return by_conjugate_gradients(b, multiply, precondition, accuracy(), left);
  }
  [[nodiscard]] std::unique_ptr<ComplexFactors> instead() const override {
    return factors_by<ComplexLu>(matrix_, factor_);
  }
  [[nodiscard]] std::string_view method() const override { return CholeskyFactors::id; }

 private:
  SparseMatrix matrix_;
  Complex factor_ = 0.0;
  std::optional<CholeskyFactors> factors_{};
};

// Conjugate gradients preconditioned by FastSineSolver with the mean stencil. When those for one matrix have
// cost about as much as factors, these solve from then on.
class ComplexConjugateGradients final : public ComplexIterations {
 public:
  using ComplexIterations::ComplexIterations;
  bool factorise(const SparseMatrix& matrix, Complex factor) override {
    constexpr Eigen::Index fewest_unknowns = 2000;  // below, factors take no longer
    if (matrix.rows() < fewest_unknowns) return false;
    auto found = as_five_point(matrix);
    if (!found || !found->diagonal.allFinite()) return false;
    if (!sines_) sines_.emplace(found->n, found->m);
    begin();
    matrix_ = std::move(*found);
    factor_ = factor;
    // Nanoseconds an unknown of LU, and of an iteration, as in ConjugateGradients.
    const auto lines = static_cast<double>(std::min(matrix_.n, matrix_.m));
    iterations_left_ =
        static_cast<int>(72.0 * std::sqrt(static_cast<double>(matrix.rows())) / (32.0 + 0.16 * lines));
    const auto mean = matrix_.mean_stencil();
    stencil_ = {1.0 - factor * mean.diagonal, -factor * mean.line_coupling, -factor * mean.cross_coupling};
    return sines_->is_stable_for(stencil_);
  }

 protected:
  [[nodiscard]] std::optional<ComplexVec> iterate(const ComplexVec& b) const override {
    const auto precondition = [&](ComplexVec& x) { sines_->solve(stencil_, x); };
    return by_conjugate_gradients(
        b, [&](const ComplexVec& x) { return product(x); }, precondition, accuracy(), iterations_left_);
  }
  [[nodiscard]] std::unique_ptr<ComplexFactors> instead() const override {
    return factors_by<ComplexLu>(to_sparse(matrix_), factor_);
  }
  [[nodiscard]] std::string_view method() const override { return "conjugate_gradients"; }

 private:
  // (1 - factor A) x.
  [[nodiscard]] ComplexVec product(const ComplexVec& x) const {
    Vec real(x.size()), imaginary(x.size());
    matrix_.multiply(x.real(), real);
    matrix_.multiply(x.imag(), imaginary);
    ComplexVec y(x.size());
    y.real() = real;
    y.imag() = imaginary;
    return x - factor_ * y;
  }

  std::optional<FastSineSolver> sines_{};
  FivePointMatrix matrix_{};
  Complex factor_ = 0.0;
  Stencil<Complex> stencil_{};
  mutable int iterations_left_ = 0;  // of all solves
};

}  // namespace

std::unique_ptr<ComplexFactors> complex_factors(const SparseMatrix& matrix, Complex factor, double accuracy) {
  if (auto factors = factors_by<ComplexTridiagonal>(matrix, factor)) return factors;
  if (auto factors = factors_by<ComplexFastSine>(matrix, factor)) return factors;
  if (auto factors = factors_by<ComplexCholesky>(matrix, factor, accuracy)) return factors;
  if (auto factors = factors_by<ComplexConjugateGradients>(matrix, factor, accuracy)) return factors;
  return factors_by<ComplexLu>(matrix, factor);
}

}  // namespace fde
