// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "fdebench/schemes/rules/two_sided/condensed_system.hpp"
#include "fdebench/schemes/rules/two_sided/two_grid_solver.hpp"

namespace fde {

// Newton's increments at all times at once: by CondensedSystem as long as its increments solve the equations,
// from then on by TwoGridSolver.
class NewtonIncrements {
 public:
  enum class First { condensed, two_grid };
  // The equations must outlive this object. first: the method to begin with.
  explicit NewtonIncrements(const GlobalEquations& equations, First first = First::condensed);

  // The increment at a guess with this residual; its values are not finite where there is none.
  GridFunction at(Run& run, const GridFunction& guess, const Residual& residual);

  // Memory of Jacobians, of the vectors of GMRES and of the factors of the coarse grid.
  [[nodiscard]] std::size_t bytes() const;

 private:
  // The relative residual of the linear equations, |r - left-hand side| / |r|.
  [[nodiscard]] double relative_residual(const GridFunction& increment, const Residual& residual) const;

  const GlobalEquations& equations_;
  Linearisation linearisation_;
  CondensedSystem condensed_;
  int coarse_steps_;
  std::unique_ptr<TwoGridSolver> two_grid_;  // nullptr: CondensedSystem is used
};

}  // namespace fde
