#pragma once

#include <functional>
#include <vector>

#include "implicit/newton.hpp"

namespace fde {

// The first s - 1 steps of a rule with start weights, each of which takes f_1 ... f_(s-1).
struct FirstEquations {
  std::vector<Matrix> weights;  // of f_0 ... f_(s-1) at each step, one row a row of the problem
  Matrix known;                 // what the rows have besides, one column a step
};

// They are one system for y_1 ... y_(s-1),
//   y_n = known_n + sum_{j<s} weights_n,j f_j,
// solved as the one step of a larger problem. A linear problem takes one factorisation, any other what
// Newton's method needs from a first guess: the steps of a rule of first order. These are taken one by one,
// so that a solution that ends within them ends the run, where the system as a whole may have another one.
// With steps that resolve the solution the result is nearer to the guess than a third of what the guess
// moved. A result that is farther away than it moved is another solution, or of no use, and counts as not
// found.
class FirstSteps {
 public:
  // The first-order rule steps over a grid: it knows the problem.
  using FirstOrder = std::function<Trajectory(const Grid&, const Options&)>;
  FirstSteps(const Problem& problem, const Grid& grid, FirstEquations equations, FirstOrder first_order);

  // The results, one column a step. The work is added to the run: each iteration counts once a step. Where
  // they are not found the result is empty, and `ending` says how.
  Matrix solve(Run& run, double tolerance, Ending& ending) const;

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
  // By the first-order rule. Of a linear problem the first step alone, which says whether a mode outruns it.
  Ending step_one_by_one(Run& run, double tolerance, Vec& guess) const;
  // Whether y is no farther from the guess than that is from y(0), each component relative to its size.
  [[nodiscard]] bool is_led_to(In y, In guess, In start) const;
  [[nodiscard]] Problem as_problem(const Vec& guess) const;
  void evaluate(In y, Out f) const;
  void differentiate(In y, OutMatrix jacobian) const;
  void differentiate_sparse(In y, SparseMatrix& jacobian) const;
  bool solve_linear(const Vec& past, Vec& y) const;

  const Problem& problem_;
  const Grid& grid_;
  Eigen::Index size_;
  FirstEquations equations_;
  FirstOrder first_order_;
};

}  // namespace fde
