#pragma once

#include <Eigen/LU>
#include <memory>
#include <vector>

#include "stepping/run.hpp"

namespace fde {

// df/dy at y, where f is f(t, y): what the problem tells of it, or forward differences of rhs, for which
// sizes tells how large the components of y are when they are not 0.
void differentiate(Run& run, const Problem& problem, double t, In y, In f, In sizes, OutMatrix jacobian);

// The matrix that Newton's method solves with at a step, mass - kappa df/dy: dense, or sparse where the
// problem tells its derivatives that way. mass is 1, and 0 in algebraic rows, which a sparse matrix has none
// of.
class NewtonMatrix {
 public:
  explicit NewtonMatrix(const Problem& problem);
  ~NewtonMatrix();
  NewtonMatrix(const NewtonMatrix&) = delete;
  NewtonMatrix& operator=(const NewtonMatrix&) = delete;

  // Takes df/dy at y, as above. Algebraic rows are divided by their largest entry, which sets kappa there.
  void update(Run& run, double t, In y, In f, In sizes, Vec& kappa);
  // The same of a linear problem, where df/dy does not depend on y.
  void update(Vec& kappa);

  void add_to_diagonal(const Vec& values);
  void factorise();
  // b becomes the solution x of (this matrix) x = b; the second of them factorises for this b alone.
  void solve(Vec& b) const;
  void factorise_and_solve(Vec& b);

  // Whether rounding decides about the solution, in whatever units the equations and unknowns are; of dense
  // matrices. Constraints that depend on each other have such a matrix, however they round.
  [[nodiscard]] bool singular() const;
  // The largest entry of a column; of dense matrices.
  [[nodiscard]] double column_size(Eigen::Index i) const { return dense_.col(i).lpNorm<Eigen::Infinity>(); }
  [[nodiscard]] const std::vector<Eigen::Index>& algebraic_rows() const { return algebraic_; }
  [[nodiscard]] const Vec& mass() const { return mass_; }

 private:
  struct Sparse;
  void assemble(Vec& kappa);  // from df/dy in its place

  const Problem& problem_;
  std::vector<Eigen::Index> algebraic_;
  Vec mass_;
  Matrix dense_;
  Eigen::PartialPivLU<Matrix> factors_;
  std::unique_ptr<Sparse> sparse_;  // null: the matrix is dense
};

}  // namespace fde
