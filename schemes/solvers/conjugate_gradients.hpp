// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "fdebench/schemes/solvers/cholesky_factors.hpp"
#include "fdebench/schemes/solvers/fast_sine_solver.hpp"

namespace fde {

// Solves with a symmetric, strictly diagonally dominant five-point matrix by preconditioned conjugate
// gradients, until Cholesky factors would have cost less.
//
// The matrix M is scaled to a unit diagonal, S M S. For smooth variable diffusivities its stencil then hardly
// varies (Concus & Golub, SIAM J. Numer. Anal. 10 (1973)). The preconditioner P is FastSineSolver with the
// mean stencil, its diagonal chosen such that x^T P x = x^T S M S x for the lowest sine mode x. Where the
// diffusivity jumps, S = 1, and the number of iterations grows like the square root of the ratio of its
// largest to its smallest value. In neither case does it grow with the number of points.
//
// Iterations end where the preconditioned residual, about the error of x, is below rounding:
//   max |(S P^(-1) S) (b - M x)| <= 2^(-53) max |x|.
//
// The budget of iterations for one matrix is the cost of its Cholesky factors. When it is spent, the matrix
// is factorised and the factors solve from then on: a matrix used for one or two solves, as on graded grids,
// needs iterations only; a matrix used for a thousand solves is soon factorised. The work is at most about
// twice the smaller work of the two methods, up to 10^5 unknowns; beyond, the factors cost more than this
// estimate (docs/large.md).
class ConjugateGradients final : public SparseFactors {
 public:
  static constexpr std::string_view id = "conjugate_gradients";

  explicit ConjugateGradients(const SparseMatrix& /*matrix*/) {}

  // Whether the matrix is large enough for iterations to be cheaper than factors.
  static bool is_applicable(const SparseMatrix& matrix);
  bool factorise(const SparseMatrix& matrix) override;
  [[nodiscard]] int determinant_sign() override { return 1; }
  void solve(Vec& b) const override;
  [[nodiscard]] std::string_view active_method() const override;
  [[nodiscard]] std::string_view chosen_method() const override { return id; }
  void state(Archive& archive) override;

  // The iterations of all solves with the matrix so far.
  [[nodiscard]] int iterations() const { return iterations_; }

 private:
  bool iterate(Vec& b) const;
  void factorise_by_cholesky() const;

  FivePointMatrix matrix_{};  // S M S
  Vec scale_;                 // the diagonal of S
  std::unique_ptr<FastSineSolver> sines_;
  Stencil<double> stencil_{};
  int factorisation_cost_ = 0;  // cost of the factors, in iterations
  mutable int iterations_ = 0;
  mutable std::unique_ptr<CholeskyFactors> cholesky_;  // its elimination order is reused for all matrices
  mutable bool factorised_ = false;
  mutable Vec x_, residual_, preconditioned_, direction_, product_;
};

}  // namespace fde
