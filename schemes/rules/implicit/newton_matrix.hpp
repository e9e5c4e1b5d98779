// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string_view>

#include "fdebench/schemes/rules/implicit/step_equations.hpp"
#include "fdebench/schemes/stepping/run.hpp"

namespace fde {

// The iteration matrix of Newton's method at a step, mass - scale df/dy (see RowScales): dense, or sparse
// where the problem has sparse derivatives. A sparse one has no algebraic rows.
class NewtonMatrix {
 public:
  NewtonMatrix() = default;
  NewtonMatrix(const NewtonMatrix&) = delete;
  NewtonMatrix& operator=(const NewtonMatrix&) = delete;
  virtual ~NewtonMatrix() = default;

  // Computes the matrix at y. f: f(t, y). It is not factorised yet.
  virtual void linearise(Run& run, const StepEquations& step, In y, In f) = 0;

  // Computes and factorises the matrix of a linear problem. Returns false where its algebraic rows determine
  // their unknowns only up to rounding, whatever the units, as where constraints are dependent.
  virtual bool factorise_linear(const Vec& kappa) = 0;

  // 1 or -1, of the factorised matrix; 0 where it is singular or not finite.
  virtual int determinant_sign() = 0;

  // Adds to the diagonal of the matrix of linearise(), before it is factorised.
  virtual void add_to_diagonal(const Vec& values) = 0;
  virtual void factorise() = 0;

  // Replaces b by the solution x of M x = b, M the factorised matrix.
  virtual void solve(Vec& b) const = 0;

  // The name of the solver of a factorised sparse matrix; empty: the matrix is dense or not factorised.
  [[nodiscard]] virtual std::string_view solver() const { return {}; }

  // Saves or restores the matrix that has been factorised last; restoring factorises it again.
  virtual void state(Archive& archive) = 0;

  // The scales of the equations that have been linearised last.
  [[nodiscard]] virtual const RowScales& rows() const = 0;
};

// A matrix for the problem's kind of derivatives. The problem must outlive it.
std::unique_ptr<NewtonMatrix> make_newton_matrix(const Problem& problem);

}  // namespace fde
