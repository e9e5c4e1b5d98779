// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "fdebench/schemes/problem/derivatives.hpp"
#include "fdebench/schemes/problem/equation.hpp"
#include "fdebench/schemes/problem/increment_form.hpp"
#include "fdebench/schemes/problem/interval.hpp"

namespace fde {

// The base point of the Caputo derivative of a row: t = 0 for left, t = end for right derivatives.
enum class Side { left, right };

// One unknown y_i and the order gamma_i > 0 of its Caputo derivative; order 0 is an algebraic row.
struct Component {
  double order;
  // initial[k], k < ceil(order), is y^(k)(0), for a right row (-1)^k y^(k)(end). An algebraic row has one
  // entry, the consistent value at t = 0 or a guess of it.
  std::vector<double> initial;
  Side side = Side::left;
};

// Whether the row of this component is 0 = f_i(t, y), without a derivative and without a memory term.
inline bool is_algebraic(const Component& component) { return component.order == 0.0; }

// The derivatives of r constraints by the n velocities, r x n, and the accelerations that their reactions
// cause for unit multipliers, n x r. The multipliers are determined where the product is regular.
struct ConstraintMatrices {
  Matrix gradients, reactions;
};

// The domain of a right-hand side, {(t, y): margin(t, y) > 0}, where constraints keep their rank. `edge`
// names its boundary, as in "r = 0".
struct Domain {
  std::string edge{};
  std::function<double(double t, In y)> margin{};                   // empty: everywhere
  std::function<ConstraintMatrices(double t, In y)> constraints{};  // empty: none that could lose it
  [[nodiscard]] bool contains(double t, In y) const { return !margin || margin(t, y) > 0.0; }
};

// A switching function of a discontinuous right-hand side (dry friction, for example): the right-hand side
// jumps where this function changes its sign along the solution.
using SwitchingFunction = std::function<double(double t, In y)>;

// f and df/dy as formulas of t and y1, y2, ..., with every operation in parentheses, so that other languages
// can evaluate them: numbers, + - * / and calls of functions, power(a,b) among them. Empty: f is not given by
// formulas, or they are too long.
struct ProblemText {
  std::vector<std::string> rhs{};
  std::vector<std::vector<std::string>> jacobian{};  // jacobian[i][j] = df_i/dy_j
};

// An interval in which f changes so quickly as a function of t alone that longer steps, or longer panels, may
// pass over the change without a sample of it.
struct StepLimit {
  double from, to, longest;
};

// Intervals that contain f_i(t, y) for all t and y of the given intervals.
using RangeOfRhs = std::function<void(const Interval& t, std::span<const Interval> y, std::span<Interval> f)>;

// A multi-order system D^(gamma_i) y_i = f_i(t, y), 0 < t <= end, with Caputo derivatives. In a right row D
// is the right derivative,
//   y_i(t) = sum_k initial[k] (end - t)^k / k! + 1/Gamma(g) int_t^end (s - t)^(g-1) f_i(s, y(s)) ds,
// -y' for order 1. An algebraic row is 0 = f_i(t, y). It may constrain unknowns of other rows, as in
// mechanics with a multiplier lambda (index 2):
//   q' = v, v' = a(t, q, v) + R(q, v)^T lambda, 0 = g(t, q, v).
// With conditions the last entries of an `initial` may be missing: they are unknown initial values.
//
// y and f have size() entries. A Jacobian is size() x size(); its row i is the gradient of f_i.
struct Problem {
  std::vector<Component> components{};
  std::function<void(double t, In y, Out f)> rhs{};
  Derivatives derivatives{};
  std::function<ProblemText()> text{};  // rhs and derivatives as formulas; empty: not known
  IncrementForm increments{};           // agrees with rhs and derivatives; for schemes that compute y - y(0)
  // The multi-term equations that the rows come from, for schemes that discretise these; rhs agrees with
  // them. Empty: the problem is not given in multi-term form.
  std::vector<Equation> equations{};
  double end = 1.0;
  // Boundary conditions residual(y(0), y(end)) = 0, as many as unknown initial values; empty: none.
  std::function<void(In at_start, In at_end, Out residual)> conditions{};
  Domain domain{};                   // a step that leaves it has crossed a singularity
  std::vector<double> jump_times{};  // the times after 0, increasing, at which rhs jumps
  std::vector<double> kink_times{};  // those at which it is continuous, but not its derivative by t
  std::vector<StepLimit> step_limits{};
  std::vector<SwitchingFunction> switching_functions{};
  RangeOfRhs range{};  // empty: f is known at points only

  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(components.size()); }
};

// Whether f = A y + b(t) with a given A and no switching functions; whether df/dy is given as a sparse
// matrix; whether df/dy is given at all.
bool is_linear(const Problem& problem);
bool has_sparse_jacobian(const Problem& problem);
bool has_jacobian(const Problem& problem);

// Writes the dense df/dy to `jacobian`, size() x size(). False, and no change, where the problem has none.
bool evaluate_jacobian(const Problem& problem, double t, In y, OutMatrix jacobian);

// The longest step from t that keeps the step limits: one that ends before an interval, or is short enough
// for it.
double longest_step(const Problem& problem, double t);

// Number of initial values of a row of this order: ceil(order), and 1 for order 0.
std::size_t initial_count(double order);

// Whether the problem has a right derivative or boundary conditions: it cannot be solved by time stepping.
bool is_two_sided(const Problem& problem);

// Number of unknown initial values.
Eigen::Index unknown_count(const Problem& problem);

// The Taylor part sum_k initial[k] t^k / k!, k < ceil(order), of every component, with 0 for unknown initial
// values; for an algebraic row the value at t = 0. t is the distance from the base point of the row: for
// right rows pass end - t.
class TaylorPart {
 public:
  explicit TaylorPart(const Problem& problem);
  void at(double t, Out value) const;

 private:
  Matrix coefficients_;  // initial[k] / k!, one row a component, one column a power
};

// The Taylor parts of all rows, left and right, at the time t of the problem.
Vec taylor_part(const Problem& problem, double t);

}  // namespace fde
