#pragma once

#include <functional>
#include <string>
#include <vector>

#include "problem/derivatives.hpp"
#include "problem/equation.hpp"

namespace fde {

// Where the Caputo derivative of a row starts: left, from t = 0; right, from t = end backwards.
enum class Side { left, right };

// One unknown y_i with the order gamma_i > 0 of its Caputo derivative, or an algebraic row: order 0.
struct Component {
  double order;
  // initial[k], k < ceil(order): y^(k)(0), of a right row (-1)^k y^(k)(end). An algebraic row has one number,
  // its value at t = 0; a guess where that is not known.
  std::vector<double> initial;
  Side side = Side::left;
};

// Whether the row of this component is 0 = f_i(t, y), without a derivative and without a past.
inline bool algebraic(const Component& component) { return component.order == 0.0; }

// Where a right-hand side is defined: where margin(t, y) > 0. The text names the edge, as in "r = 0".
struct Domain {
  std::string edge{};
  std::function<double(double t, In y)> margin{};  // empty: everywhere
  [[nodiscard]] bool contains(double t, In y) const { return !margin || margin(t, y) > 0.0; }
};

// Zero where a right-hand side jumps because of the state, as where friction turns: it jumps at each time at
// which this passes through 0.
using Switch = std::function<double(double t, In y)>;

// A multi-order system D^(gamma_i) y_i = f_i(t, y), 0 < t <= end. D of a right row is the right derivative
//   y_i(t) = sum_k initial[k] (end - t)^k / k! + 1/Gamma(g) int_t^end (s - t)^(g-1) f_i(s, y(s)) ds,
// -y' for order 1. Algebraic rows read 0 = f_i(t, y). These may constrain other unknowns than their own, as
// in mechanics with a multiplier lambda (index 2):
//   q' = v, v' = a(t, q, v) + R(q, v)^T lambda, 0 = g(t, q, v).
// With conditions the last values of an `initial` may be missing: they are unknown initial values.
//
// y, f and what is said of every row have size() entries; a Jacobian has size() rows and columns, row i the
// derivatives of f_i.
struct Problem {
  std::vector<Component> components{};
  std::function<void(double t, In y, Out f)> rhs{};
  Derivatives derivatives{};
  // The multi-term equations whose chains are among the rows, where rhs says the same; empty: none is.
  std::vector<Equation> equations{};
  double end = 1.0;
  // residual = 0, as many numbers as there are unknown initial values; empty: none is unknown.
  std::function<void(In at_start, In at_end, Out residual)> conditions{};
  Domain domain{};              // a step out of it has crossed a singularity
  std::vector<double> jumps{};  // the times after 0, increasing, at which rhs jumps
  std::vector<Switch> switches{};

  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(components.size()); }
};

// What kind of derivatives the problem has: those of a right-hand side that is linear at all times and has no
// switch; a sparse matrix; any.
bool linear(const Problem& problem);
bool sparse(const Problem& problem);
bool has_jacobian(const Problem& problem);

// jacobian becomes df/dy, dense, where the problem tells it; otherwise the result is false.
bool evaluate_jacobian(const Problem& problem, double t, In y, OutMatrix jacobian);

// Number of initial values that a row of this order needs: ceil(order), and 1 for order 0.
std::size_t initial_count(double order);

// Whether any row has a right derivative or an unknown initial value: such a problem has no direction in
// which to step.
bool two_sided(const Problem& problem);

// How many initial values are unknown.
Eigen::Index unknown_count(const Problem& problem);

// Taylor part sum_k initial[k] t^k / k! of every component, up to k < ceil(order), with 0 for unknown initial
// values; of an algebraic row its value at t = 0. t counts from where the row starts, so for right rows it is
// the time left until the end.
class TaylorPart {
 public:
  explicit TaylorPart(const Problem& problem);
  void at(double t, Out value) const;

 private:
  Matrix coefficients_;  // y^(k)(0) / k!, one column a power
};

// The same once, all at the time t of the problem.
Vec taylor_part(const Problem& problem, double t);

}  // namespace fde
