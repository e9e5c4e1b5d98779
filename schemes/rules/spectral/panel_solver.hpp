// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>
#include <string_view>

#include "fdebench/schemes/problem/resolution.hpp"
#include "fdebench/schemes/rules/spectral/panel_matrix.hpp"
#include "fdebench/schemes/stepping/error_tolerance.hpp"
#include "fdebench/schemes/stepping/run.hpp"

namespace fde {

struct PanelValues {
  Matrix unknowns, rows;  // one row a point
};

// Newton's method for all points at once, each with its own Jacobian. The rows are updated by increments
// together with the x_k, so that a row that is small beside its memory term keeps its digits where f makes it
// decay.
class PanelSolver {
 public:
  // Problem, rows and kernels must outlive this object.
  PanelSolver(const Problem& problem, const IntegratedRows& integrated_rows, const PanelKernels& kernels,
              const Tolerance& accuracy);

  // Solves from a guess of values.unknowns; the error left is small beside the tolerance. Returns false if it
  // does not converge or leaves the domain.
  bool solve(Run& run, const PanelSystem& task, PanelValues& values);

  // For problems with an infinite derivative: accepts, from now on, panels on which a fixed-point sweep
  // changes no row by more than the limit, although its effect on other rows is not known. Returns false if
  // there were none, or if they are accepted already.
  bool accept_unconverged_sweeps();

  // Computes values.rows from values.unknowns.
  void integrate(const PanelSystem& task, PanelValues& values);

  // Whether the last solve that failed left the domain.
  [[nodiscard]] bool left_domain() const { return left_domain_; }

  // The x_k at t = 0; empty where f is not finite there.
  Vec initial_unknowns(Run& run);
  // The x_k at the first point from the memory term alone; 0 where f is not finite there. Algebraic rows keep
  // their last values.
  Vec unknowns_at_first_point(Run& run, const PanelSystem& task);

  // algebraic_slopes (algebraic_slopes.hpp) at the first point.
  [[nodiscard]] Matrix algebraic_slopes(Run& run, const PanelSystem& task, const Matrix& rows);

  // The change of a row for x_k = 1 on the whole panel: its fractional integral, 1 for an algebraic row.
  [[nodiscard]] double integral_of_one(const PanelSystem& task, Eigen::Index row) const;

  // Whether the problem, linearised at the middle point, has a mode that grows by more than e^folds on the
  // panel. A growing mode that is not resolved is wrong however small it is.
  bool has_growing_mode(Run& run, const PanelSystem& task, const Matrix& rows, double folds);

  // The error limit of each row. In an algebraic row that its own equation does not determine it is at least
  // the error that changes no other row by more than its limit: at an early time t a multiplier can be found
  // up to 1/t of that only.
  [[nodiscard]] Vec error_limits(const PanelSystem& task, const Matrix& rows) const;

  // The error of Problem::outputs at the end of a panel, in units of the tolerance, for these errors of the
  // rows.
  [[nodiscard]] double error_of_outputs(const PanelSystem& task, const Matrix& rows,
                                        const Vec& errors) const {
    const Eigen::Index last = rows.rows() - 1;
    return allowed_.error_of_outputs(problem_, task.times[last], values_at(rows, last), errors,
                                     task.term_sizes);
  }

  // Measures the rounding errors of f on a panel, which error_limits() and solve() take into account from now
  // on: to be called where a panel is rejected.
  void measure_rhs_error(Run& run, const PanelSystem& task, const Matrix& rows);

  // y at a point of a panel.
  [[nodiscard]] Vec values_at(const Matrix& rows, Eigen::Index point) const {
    return integrated_rows_.origin + rows.row(point).transpose();
  }

  // The rows at the end of the last accepted panel.
  [[nodiscard]] const Vec& last_end_values() const { return last_end_values_; }

  // The method of sparse systems; empty: there were none.
  [[nodiscard]] std::string_view linear_solver() const { return matrix_->solver(); }

  // Records an accepted panel.
  void accept_panel(const PanelValues& solved);

 private:
  const Vec& rhs(Run& run, double t);  // at y_
  [[nodiscard]] Matrix sizes_of(const Matrix& rows) const;
  [[nodiscard]] Vec with_multiplier_limits(const PanelSystem& task, Vec limits) const;
  // The error of an algebraic row by its own equation where all other rows have their limits as errors;
  // infinite where the equation does not contain it.
  [[nodiscard]] double determined_error(Eigen::Index algebraic, const Vec& limits) const;
  [[nodiscard]] Vec row_limits(const PanelSystem& task, const Matrix& rows, const Vec& unresolved) const;
  [[nodiscard]] Vec unresolved(const PanelSystem& task) const;
  [[nodiscard]] Vec newton_limits(const PanelSystem& task, const Matrix& rows) const;
  Vec unknowns_from_rhs(Run& run, double t);  // at y_
  bool evaluate(Run& run, const PanelSystem& task, const Matrix& rows);
  bool linearise(Run& run, const PanelSystem& task, const Matrix& rows);
  void apply_increment(const PanelSystem& task, const Matrix& increment, Matrix& unknowns, Matrix& rows);
  [[nodiscard]] double relative_increment(const Vec& limit) const;
  [[nodiscard]] bool loses_digits(const Vec& limit) const;

  bool had_unconverged_sweep_ = false, accepts_unconverged_sweeps_ = false;
  const Problem& problem_;
  const IntegratedRows& integrated_rows_;
  const PanelKernels& kernels_;
  ErrorTolerance allowed_;
  RhsError rhs_error_;
  Vec mass_;             // 1, and 0 for an algebraic row
  Vec last_end_values_;  // the rows at the end of the last accepted panel
  PanelJacobian jacobian_;
  std::unique_ptr<PanelMatrix> matrix_;
  Vec factored_units_;  // of a linear problem: those of matrix_
  // Of a linear problem: no mode grows faster than e^(growth_rate_bound_ t).
  double growth_rate_bound_ = std::numeric_limits<double>::infinity();
  Matrix residual_, row_increments_;
  Vec y_;  // y - origin
  bool left_domain_ = false;
};

}  // namespace fde
