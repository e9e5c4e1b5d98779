// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "fdebench/schemes/stepping/run.hpp"

namespace fde {

// The error of a step that has no solution.
inline constexpr double no_solution = std::numeric_limits<double>::infinity();

// D^g y on a step as polynomials of w = (t - t_(n-1)) / (t_n - t_(n-1)): one row a component, columns the
// coefficients of 1, w, w^2. In algebraic rows the polynomials are y itself.
using DerivativePolynomials = Eigen::Matrix<double, Eigen::Dynamic, 3>;

// A component that is interpolated on a step from its own values: y as a polynomial of w, with the
// coefficients of 1, w, w^2, w^3. It replaces the fractional integral of D^g y where f makes the component
// decay within the step: f is then far larger than y, and between the stages the error of the integral
// exceeds the tolerance, though the equations of the step leave little of this error at the stages.
struct InterpolatedRow {
  Eigen::Index row;
  Eigen::Vector4d coefficients;
  // y at w.
  [[nodiscard]] double at(double w) const {
    return coefficients[0] + w * (coefficients[1] + w * (coefficients[2] + w * coefficients[3]));
  }
  void state(Archive& archive) { archive(row, coefficients); }
};
using InterpolatedRows = std::vector<InterpolatedRow>;

// Whether a component is interpolated. error: of its fractional integral; left: what remains of this error in
// the solution of the step equations; allowed: the limit of the error.
inline bool needs_interpolation(double error, double left, double allowed) {
  constexpr double small_part = 0.1;  // if more remains, the error is below 10 times the limit
  return !(std::abs(error) <= allowed) && !(std::abs(left) > small_part * std::abs(error));
}

// A rule for steps of any size. attempt() solves a step and estimates its error; then accept() adds the step
// to the history, or attempt() is called again with another size. attempt() does not change the history.
class AdaptiveRule {
 public:
  AdaptiveRule& operator=(AdaptiveRule&&) = delete;
  virtual ~AdaptiveRule() = default;

  // Solves the step from the last accepted time to t. Returns its error estimate in units of the tolerance,
  // or no_solution.
  virtual double attempt(Run& run, double t) = 0;

  // The error of the last attempt if f jumps on its step, counted once, as no other step makes this error.
  // no_solution: f does not jump, or attempt() returns the error of one step anyway.
  [[nodiscard]] virtual double error_of_jump() const { return no_solution; }

  // y at the end of the last attempt, and at a time t within its step (dense_output).
  [[nodiscard]] virtual const Vec& result() const = 0;
  // The error that each component may have in the last attempt.
  [[nodiscard]] virtual Vec limits() const = 0;
  virtual Vec dense_output(double t) = 0;

  // y at a time t after the last accepted one, with f extrapolated from the accepted steps.
  virtual Vec extrapolate(double t) = 0;

  // Replaces attempt() for a step over a jump of f that is too short to change y: f is extrapolated over it.
  virtual void extrapolate_over_jump(double t) = 0;
  // Evaluates f behind the jump, where the rule needs it before accept().
  virtual void evaluate_behind_jump(Run& /*run*/) {}

  // Accepts the last attempt: adds it to the history.
  virtual void accept() = 0;

  // D^g y on the last accepted step, and the components that are interpolated on it.
  [[nodiscard]] virtual DerivativePolynomials derivative_polynomials() const = 0;
  [[nodiscard]] virtual const InterpolatedRows& interpolated_rows() const = 0;
  // The slopes of algebraic rows (algebraic_slopes.hpp) that are left out of their polynomials on the last
  // accepted step; empty: none.
  [[nodiscard]] virtual const Matrix& slopes_left_out() const {
    static const Matrix none;
    return none;
  }

  // Restarts after a jump of f at the last accepted time: f is no longer extrapolated from the steps before
  // it.
  virtual void restart(Run& run) = 0;

  // The power of the step size with which the error estimate falls where the solution is smooth.
  [[nodiscard]] virtual double rate() const = 0;

  // Memory of the history.
  [[nodiscard]] virtual std::size_t bytes() const = 0;

  // The method that solved sparse equations of the steps; empty: there were none.
  [[nodiscard]] virtual std::string_view linear_solver() const = 0;

  // Saves or restores the state between two steps.
  virtual void state(Archive& archive) = 0;
};

}  // namespace fde
