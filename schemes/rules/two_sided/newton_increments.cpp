// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/two_sided/newton_increments.hpp"

#include <cmath>

namespace fde {
namespace {

constexpr int least_coarse_steps = 64, most_coarse_steps = 256;
constexpr double solved = 1e-6;  // largest relative residual of an accepted increment

}  // namespace

NewtonIncrements::NewtonIncrements(const GlobalEquations& equations, First first)
    : equations_(equations),
      linearisation_(equations),
      condensed_(linearisation_),
      coarse_steps_(least_coarse_steps),
      two_grid_(first == First::condensed ? nullptr
                                          : std::make_unique<TwoGridSolver>(equations, coarse_steps_)) {}

GridFunction NewtonIncrements::at(Run& run, const GridFunction& guess, const Residual& residual) {
  linearisation_.update(run, guess, residual);
  if (!two_grid_) {
    GridFunction increment = condensed_.solution(residual);
    if (relative_residual(increment, residual) <= solved) return increment;
    two_grid_ = std::make_unique<TwoGridSolver>(equations_, coarse_steps_);
  }
  while (true) {
    two_grid_->update(run, guess);
    GridFunction increment = two_grid_->solution(linearisation_, residual);
    if (relative_residual(increment, residual) <= solved || coarse_steps_ >= most_coarse_steps ||
        coarse_steps_ >= equations_.grid().steps)
      return increment;
    coarse_steps_ *= 2;
    two_grid_ = std::make_unique<TwoGridSolver>(equations_, coarse_steps_);
  }
}

double NewtonIncrements::relative_residual(const GridFunction& increment, const Residual& residual) const {
  const auto done = linearisation_.left_hand_sides(increment);
  const Residual left{
      .rows = residual.rows - done.rows, .conditions = residual.conditions + done.conditions, .f = {}};
  const double of = residual.norm();
  return of > 0.0 ? left.norm() / of : 0.0;
}

std::size_t NewtonIncrements::bytes() const {
  return linearisation_.bytes() + condensed_.bytes() + (two_grid_ ? two_grid_->bytes() : 0);
}

}  // namespace fde
