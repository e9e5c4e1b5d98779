// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "fdebench/schemes/problem/interval.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// The right-hand side of a problem and its Jacobian as functions of z = y - origin, where origin_i is y_i(0),
// and 0 in an algebraic row. Where f contains differences y_i - y_i(0), it has their relative accuracy, which
// y loses next to t = 0 by rounding.
struct IncrementForm {
  Vec origin{};  // empty: the problem has no such form
  std::function<void(double t, In z, Out f)> rhs{};
  std::function<void(double t, In z, OutMatrix jacobian)> jacobian{};

  [[nodiscard]] bool is_given() const { return origin.size() > 0; }
};

// One term coefficient * D^order u of a multi-term equation.
struct Term {
  double coefficient;
  double order;
};

// A multi-term equation of a problem for an unknown u,
//   a D^leading u + factor(t, y) sum_k c_k D^(a_k) u = force(t, y)        (Yin, Liu & Anh 2007, eq. 1.1)
// where y is the state of the whole problem. The rows first_row, first_row + 1, ... of the problem are the
// chain of this equation: u and its derivatives of orders below the leading one (chain.hpp).
struct Equation {
  Eigen::Index first_row;
  Term leading;
  std::vector<Term> terms;  // by increasing order, each order once; no coefficient is 0
  std::function<double(double t, In y)> force, factor;
  // The force as a formula, as ProblemText has them; empty: not known, or there is a factor.
  std::function<std::string()> force_text{};
};

// How a problem gives df/dy, a size() x size() matrix. With NoDerivatives implicit schemes use differences of
// the right-hand side. The sparse forms are for problems in which most entries are 0; precondition: all rows
// have left derivatives.
struct NoDerivatives {};
struct DenseJacobian {
  std::function<void(double t, In y, OutMatrix jacobian)> at;
};
struct SparseJacobian {
  std::function<void(double t, In y, SparseMatrix& jacobian)> at;
};
// The constant matrix A of f(t, y) = A y + b(t): a scheme factorises once.
struct DenseLinearPart {
  Matrix matrix;
};
struct SparseLinearPart {
  SparseMatrix matrix;
};

using Derivatives =
    std::variant<NoDerivatives, DenseJacobian, SparseJacobian, DenseLinearPart, SparseLinearPart>;

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

// A solution at earlier times: writes y(t) to y.
using Past = std::function<void(double t, Out y)>;

// Constant delays: f depends on y(t - lags[k]) too, and a problem with delays has this rhs in place of its
// own.
struct Delays {
  std::vector<double> lags{};  // increasing, above 0; empty: no delays
  Past before{};               // y(t) for t < 0
  // f(t, y) and, where `derivatives` of the problem do not hold, df/dy. `past` gives y at t - lags[k].
  std::function<void(double t, In y, const Past& past, Out f)> rhs{};
  std::function<void(double t, In y, const Past& past, OutMatrix jacobian)> jacobian{};
};

// The direction in which an event function passes through 0.
enum class Crossing { either, rising, falling };

// An event at which y jumps: where `value` changes its sign along the solution, but not at t = 0, y becomes
// `state`. The history goes on: with the jumps d_k at the times t_k,
//   y(t) = Taylor part + sum over t_k < t of d_k + 1/Gamma(g) int_0^t (t - s)^(g-1) f(s, y(s)) ds.
struct Reset {
  std::function<double(double t, In y)> value{};
  Crossing crossing = Crossing::either;  // zeros in the other direction do not count
  std::function<void(double t, In y, Out state)>
      state{};  // changes some entries of y, none of algebraic rows
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
// With delays f depends on earlier values of y too, and the history of y begins with delays.before.
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
  // Functions of the state that are wanted as accurately as y, where they may magnify its errors: schemes
  // with adaptive step size test their errors too. Empty: none.
  std::function<Vec(double t, In y)> outputs{};
  Domain domain{};                   // a step that leaves it has crossed a singularity
  std::vector<double> jump_times{};  // the times after 0, increasing, at which rhs jumps
  std::vector<double> kink_times{};  // those at which it is continuous, but not its derivative by t
  std::vector<StepLimit> step_limits{};
  std::vector<SwitchingFunction> switching_functions{};
  RangeOfRhs range{};  // empty: f is known at points only
  Delays delays{};
  std::vector<Reset> resets{};  // for schemes with adaptive step size, which locate events

  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(components.size()); }
  [[nodiscard]] const Component& component(Eigen::Index i) const {
    return components[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] bool is_algebraic(Eigen::Index row) const { return fde::is_algebraic(component(row)); }
};

// Whether there are rows of order 0; these rows.
bool has_algebraic_rows(const Problem& problem);
std::vector<Eigen::Index> algebraic_rows(const Problem& problem);

// The orders of all rows.
Vec orders_of(const Problem& problem);

// f(t, y).
Vec rhs_at(const Problem& problem, double t, In y);

// Whether f = A y + b(t) with a given A and no switching functions; whether df/dy is given as a sparse
// matrix; whether df/dy is given at all.
bool is_linear(const Problem& problem);
bool has_sparse_jacobian(const Problem& problem);
bool has_jacobian(const Problem& problem);

// Writes the dense df/dy to `jacobian`, size() x size(). False, and no change, where the problem has none.
bool evaluate_jacobian(const Problem& problem, double t, In y, OutMatrix jacobian);

// The sparse df/dy: the constant matrix of a linear problem, otherwise `buffer` with the values at (t, y).
// Precondition: has_sparse_jacobian(problem).
const SparseMatrix& sparse_jacobian_at(const Problem& problem, double t, In y, SparseMatrix& buffer);

// The longest step from t that keeps the step limits: one that ends before an interval, or is short enough
// for it.
double longest_step(const Problem& problem, double t);

// Number of initial values of a row of this order: ceil(order), and 1 for order 0.
std::size_t initial_count(double order);

// The smallest order of the rows that are not algebraic, at most 1.
double smallest_order(const Problem& problem);

// Whether the problem has a right derivative: it cannot be solved by time stepping. Whether it has one or
// boundary conditions: its solution depends on its end. Whether it has conditions alone: initial value
// problems are solved to find the unknown initial values (shooting.hpp).
bool has_right_rows(const Problem& problem);
bool is_two_sided(const Problem& problem);
bool is_solved_by_shooting(const Problem& problem);

// Number of unknown initial values.
Eigen::Index unknown_count(const Problem& problem);

// The initial value problem with these unknown initial values, row by row and by increasing derivative, and
// without conditions. Precondition: there are unknown_count(problem) values.
Problem with_initial_values(Problem problem, In unknown);

// The same with 1 for each, where only the form of the problem counts: values that are not 0. A problem
// without conditions is itself.
Problem with_some_initial_values(const Problem& problem);

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

// The times at which f, or its derivative by t, jumps, increasing: a polynomial resolves f on one side of
// each.
std::vector<double> breaking_points(const Problem& problem);

// For each of problem.switching_functions whether it is positive at (t, y).
std::vector<bool> switch_signs(const Problem& problem, double t, In y);

// df/dy at (t, y), dense: the Jacobian that the problem gives, otherwise central differences with the
// increments 2^-18 max(1, |y_j|).
Matrix jacobian_at(const Problem& problem, double t, Vec y);

}  // namespace fde
