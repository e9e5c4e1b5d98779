#pragma once

#include <memory>
#include <string_view>

#include "implicit/step_equations.hpp"
#include "stepping/run.hpp"

namespace fde {

// The matrix that Newton's method solves with at a step, mass - scale df/dy: dense, or sparse where the
// problem tells its derivatives that way. A sparse one has no algebraic rows.
class NewtonMatrix {
 public:
  NewtonMatrix() = default;
  NewtonMatrix(const NewtonMatrix&) = delete;
  NewtonMatrix& operator=(const NewtonMatrix&) = delete;
  virtual ~NewtonMatrix() = default;

  // Becomes the matrix at y, where f is f(t, y).
  virtual void linearise(Run& run, const StepEquations& step, In y, In f) = 0;

  // Becomes the factorised matrix of a linear problem. False where rounding decides about the solution of its
  // algebraic rows, in whatever units these and the unknowns are: so it is where constraints depend on each
  // other.
  virtual bool factorise_linear(const Vec& kappa) = 0;

  // 1 or -1, of the factorised matrix; 0 where it is singular or not finite.
  virtual int determinant_sign() = 0;

  virtual void add_to_diagonal(const Vec& values) = 0;
  virtual void factorise() = 0;

  // b becomes the solution x of (the factorised matrix) x = b.
  virtual void solve(Vec& b) const = 0;

  // The name of the method, of a sparse matrix that is factorised; empty: it says none.
  [[nodiscard]] virtual std::string_view solver() const { return {}; }

  // The matrix that has been factorised last: the factors are made of it again.
  virtual void state(Archive& archive) = 0;

  // Those of the equations that have been linearised last.
  [[nodiscard]] virtual const RowScales& rows() const = 0;
};

// Of the kind of the problem's derivatives. The problem has to outlive it.
std::unique_ptr<NewtonMatrix> make_newton_matrix(const Problem& problem);

}  // namespace fde
