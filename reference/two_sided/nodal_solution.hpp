// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "fdebench/reference/two_sided/nodal_equations.hpp"

namespace fde::reference {

// Solution of a problem with left and right derivatives, unknown initial values and conditions, at all nodes
// of a basis at once by Newton's method. The problem and the basis must outlive this object.
class NodalSolution {
 public:
  // Newton's method starts from y = start(t) at the nodes, or from the Taylor part. Throws std::runtime_error
  // where it does not converge, std::invalid_argument for algebraic rows.
  NodalSolution(const Problem& problem, const NodalBasis& basis,
                const std::function<Vec(RelativeTime t)>& start = {});

  // y at the nodes, one row per node.
  [[nodiscard]] const Matrix& at_nodes() const { return values_.y; }
  // y at any time, by the integral of f.
  [[nodiscard]] Vec at(RelativeTime t) const { return equations_.at(t, f_, values_.unknown); }

 private:
  NodalEquations equations_;
  NodalValues values_;
  Matrix f_;
};

// The smallest, by the mean of |y|^2 over time, of the solutions that Newton's method finds from
// initial_guesses(). Throws std::runtime_error where it finds none. The problem and the basis must outlive
// the result.
NodalSolution smallest_solution(const Problem& problem, const NodalBasis& basis);

}  // namespace fde::reference
