// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/rules/implicit/newton.hpp"
#include "fdebench/schemes/stepping/grid_stepper.hpp"

namespace fde {

// The base of a scheme over a grid each of whose steps is an equation y_n = known + kappa f(t_n, y_n).
template <class Rule>
class NewtonStepper : public GridStepper<Rule> {
 public:
  void rule_state(Archive& archive) { archive(newton_); }
  void finish(Trajectory& path) { path.cost.linear_solver = newton_.linear_solver(); }

 protected:
  NewtonStepper(const Problem& problem, const Grid& grid, const Options& options)
      : GridStepper<Rule>(problem, grid, options), newton_(problem, options.newton_tolerance) {}
  ~NewtonStepper() = default;

  // Solves the equation of the step for y_, from y_(n-1).
  SolveStatus solve(const Vec& kappa, const Vec& known) {
    const auto ending =
        newton_.solve(this->run_, {this->t(), kappa, known, this->jumps().before(this->t())}, this->y_);
    this->result_ = &newton_.delivered(this->y_);
    return ending;
  }

  // f(t_(n-1), y_(n-1)), until the next call.
  const Vec& rhs_before() { return newton_.rhs_at_solution(this->run_, this->before(), this->solution_); }

  NewtonSolver newton_;
};

}  // namespace fde
