#pragma once

#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "stepping/run.hpp"

namespace fde {

// The error of a step that has no solution.
inline constexpr double no_solution = std::numeric_limits<double>::infinity();

// The drives on a step as polynomials of its share w, one row a row: coefficients of 1, w, w^2. Of algebraic
// rows y itself.
using Drives = Eigen::Matrix<double, Eigen::Dynamic, 3>;

// A row that is known on a step by its values better than by its drive: y as a polynomial of the share w,
// coefficients of 1, w, w^2, w^3. Where f makes a row decay within the step, f is by far larger than the row:
// between the points of the rule what is wrong in it is worth more than is allowed, though its equations
// leave next to nothing of that at the points.
struct InterpolatedRow {
  Eigen::Index row;
  Eigen::Vector4d powers;
  // y at the share w of the step.
  [[nodiscard]] double at(double w) const {
    return powers[0] + w * (powers[1] + w * (powers[2] + w * powers[3]));
  }
  void state(Archive& archive) { archive(row, powers); }
};
using InterpolatedRows = std::vector<InterpolatedRow>;

// Whether a row is such a one, from an error of its integral and what the equations of the step leave of it.
inline bool known_by_values(double error, double left, double allowed) {
  constexpr double small_part = 0.1;  // with more of it left the integral is within ten times what is allowed
  return !(std::abs(error) <= allowed) && !(std::abs(left) > small_part * std::abs(error));
}

// A rule that steps by any length: each step is attempted, its error is estimated, and it is taken or
// attempted anew with another length. What is not taken leaves no trace.
class AdaptiveSteps {
 public:
  AdaptiveSteps() = default;
  AdaptiveSteps(const AdaptiveSteps&) = delete;
  AdaptiveSteps& operator=(const AdaptiveSteps&) = delete;
  virtual ~AdaptiveSteps() = default;

  // Solves the step from the last time taken to t. The result is its error in units of what is allowed.
  virtual double attempt(Run& run, double t) = 0;

  // The error of the last attempt where f jumps on its step, an error that no other step makes; no_solution:
  // f does not, or the error of an attempt is that of one step anyway.
  [[nodiscard]] virtual double error_of_jump() const { return no_solution; }

  // y at the end of the last attempt, and within its step.
  [[nodiscard]] virtual const Vec& result() const = 0;
  virtual Vec between(double t) = 0;

  // y at a time after the last one taken, where f goes on as on the steps before.
  virtual Vec continued(double t) = 0;

  // In place of an attempt: the step over a jump of f, too short to change y, on which f goes on as before.
  virtual void coast(Run& run, double t) = 0;

  // The last attempt joins the past.
  virtual void take() = 0;

  // What it left there, and rows of which its values say more.
  [[nodiscard]] virtual Drives drives() const = 0;
  [[nodiscard]] virtual const InterpolatedRows& interpolated() const = 0;

  // The right-hand side has jumped at the last time taken: nothing before tells how it goes on.
  virtual void begin_anew(Run& run) = 0;

  // With which power of the length its error falls where the solution is smooth.
  [[nodiscard]] virtual double rate() const = 0;

  [[nodiscard]] virtual std::size_t bytes() const = 0;

  // What solves sparse equations of a step; empty: there were none.
  [[nodiscard]] virtual std::string_view linear_solver() const = 0;

  // Between two steps: what it keeps of those taken.
  virtual void state(Archive& archive) = 0;
};

}  // namespace fde
