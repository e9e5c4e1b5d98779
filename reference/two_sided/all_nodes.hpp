#pragma once

#include <functional>
#include <vector>

#include "two_sided/nodal_equations.hpp"

namespace fde {

// A problem with both sides, unknown initial values and conditions, solved at all nodes of a basis at once by
// Newton's method. Both must live as long.
class NodalSolution {
 public:
  // From y at the nodes, or from the Taylor part. Throws std::runtime_error where Newton's method does not
  // converge, std::invalid_argument for algebraic rows.
  NodalSolution(const Problem& problem, const NodalBasis& basis,
                const std::function<Vec(BothShares t)>& start = {});

  // y at the nodes, a row a node.
  [[nodiscard]] const Matrix& at_nodes() const { return values_.y; }
  // y between them, by the integral of f.
  [[nodiscard]] Vec at(BothShares t) const { return equations_.at(t, f_, values_.unknown); }

 private:
  NodalEquations equations_;
  NodalValues values_;
  Matrix f_;
};

// The smallest solution, by the mean of |y|^2 over time, to which Newton's method comes from other_starts.
// Throws std::runtime_error where it comes to none.
NodalSolution smallest_solution(const Problem& problem, const NodalBasis& basis);

}  // namespace fde
