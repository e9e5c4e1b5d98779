#pragma once

#include "two_sided/nodal_equations.hpp"

namespace fde {

// A problem with both sides, unknown initial values and conditions, solved at all nodes of a basis at once by
// Newton's method. Both must live as long.
class NodalSolution {
 public:
  // Throws std::runtime_error where Newton's method does not converge, std::invalid_argument for algebraic
  // rows.
  NodalSolution(const Problem& problem, const NodalBasis& basis);

  // y at the nodes, a row a node.
  [[nodiscard]] const Matrix& at_nodes() const { return values_.y; }
  // y between them, by the integral of f.
  [[nodiscard]] Vec at(BothShares t) const { return equations_.at(t, f_, values_.unknown); }

 private:
  NodalEquations equations_;
  NodalValues values_;
  Matrix f_;
};

}  // namespace fde
