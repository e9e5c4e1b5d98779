#pragma once

#include <Eigen/LU>
#include <limits>

#include "problem/resolution.hpp"
#include "spectral/panel_kernels.hpp"
#include "stepping/allowed_error.hpp"
#include "stepping/run.hpp"

namespace fde {

// What a panel solves for: at every place x_k = f, or 0 = f for an algebraic row, with the rows
//   y_i = past_i + I^(order_i) x_(drive of i).
struct PanelTask {
  Vec times;    // of the places
  Vec units;    // PanelKernels::units of its length
  Matrix past;  // one row a place, one column a row of the problem
  Vec size;     // of the terms that each row is the sum of: what its rounding is relative to
};
struct PanelValues {
  Matrix drives, rows;  // one row a place
};

// Newton's method for all places at once, each with its own Jacobian. The rows move with the drives by
// increments, so that a row that is small beside its past keeps its digits where f makes it decay.
class PanelSolver {
 public:
  PanelSolver(const Problem& problem, const DrivenRows& driven, const PanelKernels& kernels,
              const Accuracy& accuracy);

  // From a guess of the drives; what is left is small beside the accuracy. False: it does not converge, or
  // leads out of the domain.
  bool solve(Run& run, const PanelTask& task, PanelValues& values);

  // Where a derivative is infinite: takes, from now on, panels on which a sweep moves no row by more than may
  // be left, though what that moves others by is not known. False: there were none, or they are taken
  // already.
  bool take_unsettled();

  // The rows that drives make.
  void follow(const PanelTask& task, PanelValues& values);

  // Whether the last iteration that came to no end was out of the domain.
  [[nodiscard]] bool left_domain() const { return left_domain_; }

  // The drives at t = 0; empty where f is not finite there.
  Vec first_drives(Run& run);
  // Those that the past alone makes at the first place; 0 where f is not finite there. Algebraic rows are as
  // they were last.
  Vec drives_at(Run& run, const PanelTask& task);

  // What a row's integral makes of a drive of 1 all over the panel.
  [[nodiscard]] double unit_of(const PanelTask& task, Eigen::Index row) const;

  // Whether the problem, linearised at the middle place, has a mode that grows by more than e^folds on the
  // panel. What grows and is not resolved is wrong however small.
  bool grows(Run& run, const PanelTask& task, const Matrix& rows, double folds);

  // What may be wrong in each row. In an algebraic row it is at least what moves no other row by more than
  // may be wrong there: at an early time t a multiplier is known up to 1/t of that only.
  [[nodiscard]] Vec allowed(const PanelTask& task, const Matrix& rows) const;

  // The rows at the end of the last panel passed.
  [[nodiscard]] const Vec& held() const { return held_; }

  // Takes a panel as solved.
  void pass(const PanelValues& solved);

 private:
  [[nodiscard]] Vec with_unfelt(const PanelTask& task, Vec limits) const;
  [[nodiscard]] Vec left_over(const PanelTask& task, const Matrix& rows) const;
  Vec drives_of(Run& run, double t);  // at y_
  void feel();
  void differentiate(Run& run, double t, In sizes);
  bool evaluate(Run& run, const PanelTask& task, const Matrix& rows);
  bool linearise(Run& run, const PanelTask& task, const Matrix& rows);
  void move(const PanelTask& task, const Matrix& increment, Matrix& drives, Matrix& rows);
  [[nodiscard]] double part_moved(const Vec& limit) const;
  [[nodiscard]] bool cancels(const Vec& limit) const;

  bool has_unsettled_ = false, takes_unsettled_ = false;
  const Problem& problem_;
  const DrivenRows& driven_;
  const PanelKernels& kernels_;
  AllowedError allowed_;
  Vec mass_;     // 1, and 0 of an algebraic drive
  Vec held_;     // the rows at the end of the last panel passed
  Matrix felt_;  // the largest slopes of the drives of the panel by algebraic rows
  Eigen::PartialPivLU<Matrix> factors_;
  Vec factored_units_;                                          // of a linear problem
  double calm_rate_ = std::numeric_limits<double>::infinity();  // of a linear problem: no mode grows faster
  Matrix right_, moved_, jacobian_, matrix_;
  Vec y_, f_;
  bool left_domain_ = false;
};

}  // namespace fde
