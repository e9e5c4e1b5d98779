// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "fdebench/schemes/rules/implicit/newton.hpp"
#include "fdebench/schemes/solvers/sylvester_factors.hpp"

namespace fde {

// The equations of the first s - 1 steps of a rule with starting weights, each of which contains all of
// f_1 ... f_(s-1).
struct StartingEquations {
  std::vector<Matrix> weights;      // that differ: of f_0 ... f_(s-1), one row a step, one column a sample
  std::vector<std::size_t> of_row;  // the index of its weights, for each component
  Matrix known;                     // the other terms, one row a component, one column a step
};

// Solves the first steps as one system for y_1 ... y_(s-1),
//   y_n = known_n + sum_{j<s} weights_n,j f_j.
// Where df/dy is sparse and all components have the same weights, one df/dy for all steps decouples them
// (SylvesterFactors). That solves linear problems, and is the preconditioner of GMRES in each iteration of
// Newton's method for others. In other cases, and where these iterations do not converge, the system is
// solved by Newton's method with the assembled matrix of all steps.
//
// The iterations start from the steps of a first-order rule, taken one by one: a solution that ceases to
// exist within these steps ends the run, although the whole system may have another solution. If the steps
// resolve the solution, the distance of the result from this guess is less than a third of the distance of
// the guess from y(0). A result that is farther from the guess than the guess is from y(0) is another
// solution or useless, and counts as not converged.
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
  [[nodiscard]] Eigen::Index steps() const { return equations_.known.cols(); }
  // The weights of f_j at step n, one a component.
  [[nodiscard]] auto weights(Eigen::Index n, Eigen::Index j) const {
    return Vec::NullaryExpr(size_, [=, this](Eigen::Index i) {
      return equations_.weights[equations_.of_row[static_cast<std::size_t>(i)]](n - 1, j);
    });
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
  // Whether the weights are the same in all rows and df/dy is sparse.
  [[nodiscard]] bool has_sylvester_form() const;
  // Of f_1 ... f_(s-1), one row a step. Precondition: they are the same in all rows.
  [[nodiscard]] Matrix weights_of_steps() const { return equations_.weights.front().rightCols(steps()); }
  // Newton iterations from y with decoupled steps, two for a linear problem: its second one corrects the
  // rounding of the first, which the weights amplify. nullopt: they do not converge, or a matrix is singular.
  std::optional<SolveStatus> iterate_decoupled(Run& run, double tolerance, const Vec& known, Vec& y) const;
  // The increment with df/dy at each step, where b is the one with the df/dy of the factors at all steps.
  [[nodiscard]] Vec with_all_jacobians(const SylvesterFactors& factors, const Vec& y, const Vec& b) const;
  [[nodiscard]] Problem as_single_step_problem(const Vec& guess) const;
  void evaluate(In y, Out f) const;
  // known + sum_{0<j<s} weights_n,j f_j - y.
  [[nodiscard]] Vec residual(const Vec& known, const Vec& y) const;
  void differentiate(In y, OutMatrix jacobian) const;
  void differentiate_sparse(In y, SparseMatrix& jacobian) const;
  SolveStatus solve_linear(Run& run, const Vec& known, Vec& y) const;
  SolveStatus solve_by_newton(Run& run, double tolerance, const Vec& known, Vec& y) const;

  const Problem& problem_;
  const Grid& grid_;
  Eigen::Index size_;
  StartingEquations equations_;
  FirstOrder first_order_;
};

}  // namespace fde
