#pragma once

#include <memory>

#include "implicit/cholesky_factors.hpp"
#include "implicit/fast_sine.hpp"

namespace fde {

// Solves with a symmetric five-point matrix whose diagonal outweighs the rest by conjugate gradients, until
// its factors would have cost less.
//
// The matrix M is scaled to a diagonal of 1, S M S. As Concus & Golub (SIAM J. Numer. Anal. 10 (1973)) found
// for variable diffusivities that are smooth, its stencil then hardly varies: FastSine solves with the mean
// one, whose diagonal is chosen to give the lowest mode of sines its share x^T S M S x. Where the diffusivity
// jumps, S = 1, and the number of iterations grows like the root of the ratio of its largest to its smallest
// value. In neither case does it grow with the number of points.
//
// Iterations end where what the preconditioner makes of the residual, about the error of x, is below
// rounding:
//   max |(S P^(-1) S) (b - M x)| <= 2^(-53) max |x|.
//
// Each iteration is paid for out of what Cholesky's factors would cost. When that is spent on one matrix, its
// factors are made and take over: with a matrix that serves for one or two solves, as on graded grids,
// iterations are all there is; with one that serves for a thousand they soon are over. The work is at most
// about twice the least that either way alone would have been, up to 10^5 unknowns; beyond, factors cost more
// than the price that is taken for them (docs/large.md).
class ConjugateGradients final : public SparseFactors {
 public:
  static constexpr std::string_view id = "conjugate_gradients";

  explicit ConjugateGradients(const SparseMatrix& /*matrix*/) {}

  static bool fits(const SparseMatrix& matrix);
  bool factorise(const SparseMatrix& matrix) override;
  [[nodiscard]] int determinant_sign() override { return 1; }
  void solve(Vec& b) const override;
  [[nodiscard]] std::string_view name() const override;
  [[nodiscard]] std::string_view method() const override { return id; }
  void state(Archive& archive) override;

  // Of all solves with the matrix so far.
  [[nodiscard]] int iterations() const { return spent_; }

 private:
  bool iterate(Vec& b) const;
  void make_factors() const;

  FivePoint matrix_{};  // S M S
  Vec scale_;           // the diagonal of S
  std::unique_ptr<FastSine> sines_;
  Stencil<double> stencil_{};
  int price_ = 0;  // of the factors, in iterations
  mutable int spent_ = 0;
  mutable std::unique_ptr<CholeskyFactors> cholesky_;  // its order of elimination serves for all matrices
  mutable bool factorised_ = false;
  mutable Vec x_, rest_, answer_, direction_, product_;
};

}  // namespace fde
