// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "fdebench/schemes/rules/implicit/newton.hpp"

namespace fde {

// The equations of the first s - 1 steps of a rule with starting weights, each of which contains all of
// f_1 ... f_(s-1).
struct StartingEquations {
  std::vector<Matrix> weights;  // one matrix a step: the weights of f_0 ... f_(s-1), one row a component
  Matrix known;                 // the other terms, one row a component, one column a step
};

// Solves the first steps as one system for y_1 ... y_(s-1),
//   y_n = known_n + sum_{j<s} weights_n,j f_j.
// A linear problem needs one factorisation. Otherwise Newton's method starts from the steps of a first-order
// rule, taken one by one: a solution that ceases to exist within these steps ends the run, although the whole
// system may have another solution. If the steps resolve the solution, the distance of the result from this
// guess is less than a third of the distance of the guess from y(0). A result that is farther from the guess
// than the guess is from y(0) is another solution or useless, and counts as not converged.
class StartingProcedure {
 public:
  // Solves the same problem over a grid with a rule of first order.
  using FirstOrder = std::function<Trajectory(const Grid&, const Options&)>;
  StartingProcedure(const Problem& problem, const Grid& grid, StartingEquations equations,
                    FirstOrder first_order);

  // y_1 ... y_(s-1), one column a step. Adds the rhs calls and iterations to run.cost(), each iteration once
  // a step. On failure the result is empty and `ending` is the reason, otherwise SolveStatus::finished.
  Matrix solve(Run& run, double tolerance, SolveStatus& ending) const;

 private:
  [[nodiscard]] double time(Eigen::Index n) const { return grid_.time(static_cast<int>(n)); }
  [[nodiscard]] Eigen::Index steps() const { return std::ssize(equations_.weights); }
  [[nodiscard]] const Matrix& of(Eigen::Index n) const {
    return equations_.weights[static_cast<std::size_t>(n - 1)];
  }
  template <class Values>
  [[nodiscard]] auto step(Values& values, Eigen::Index n) const {
    return values.segment((n - 1) * size_, size_);
  }
  // Takes the steps of the first-order rule and writes them to `guess`. For a linear problem it takes only
  // the first step, to detect a step that is too large for a growing mode.
  SolveStatus take_first_order_steps(Run& run, double tolerance, Vec& guess) const;
  // Whether the distance of y from the guess is at most that of the guess from y(0), relative to the size of
  // each component.
  [[nodiscard]] bool is_near_guess(In y, In guess, In start) const;
  [[nodiscard]] Problem as_single_step_problem(const Vec& guess) const;
  void evaluate(In y, Out f) const;
  void differentiate(In y, OutMatrix jacobian) const;
  void differentiate_sparse(In y, SparseMatrix& jacobian) const;
  bool solve_linear(const Vec& known, Vec& y) const;

  const Problem& problem_;
  const Grid& grid_;
  Eigen::Index size_;
  StartingEquations equations_;
  FirstOrder first_order_;
};

}  // namespace fde
