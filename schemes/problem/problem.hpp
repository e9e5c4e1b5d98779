#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

namespace fde {

using Vec = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
using In = const Eigen::Ref<const Vec>&;
using Out = Eigen::Ref<Vec>;
using OutMatrix = Eigen::Ref<Matrix>;

// One unknown y_i with the order gamma_i > 0 of its Caputo derivative from t = 0, or an algebraic row: order
// 0.
struct Component {
  double order;
  // initial[k] = y^(k)(0) for k < ceil(order). An algebraic row has one number, its value at t = 0; a guess
  // where that is not known.
  std::vector<double> initial;
};

// Whether the row of this component is 0 = f_i(t, y), without a derivative and without a past.
inline bool algebraic(const Component& component) { return component.order == 0.0; }

// A multi-order system D^(gamma_i) y_i = f_i(t, y), 0 < t <= end, in which algebraic rows read 0 = f_i(t, y).
// These may constrain other unknowns than their own, as in mechanics with a multiplier lambda (index 2):
//   q' = v, v' = a(t, q, v) + R(q, v)^T lambda, 0 = g(t, q, v).
struct Problem {
  std::vector<Component> components{};
  std::function<void(double t, In y, Out f)> rhs{};
  std::function<void(double t, In y, OutMatrix jacobian)>
      jacobian{};                       // df/dy; empty: implicit schemes difference rhs
  std::optional<Matrix> linear_part{};  // A, where f(t, y) = A y + b(t): solved with one factorisation
  double end = 1.0;

  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(components.size()); }
};

// Number of initial values that a row of this order needs: ceil(order), and 1 for order 0.
std::size_t initial_count(double order);

// Taylor part sum_k y^(k)(0) t^k / k! of every component, up to k < ceil(order); of an algebraic row its
// value at t = 0.
class TaylorPart {
 public:
  explicit TaylorPart(const Problem& problem);
  void at(double t, Out value) const;

 private:
  Matrix coefficients_;  // y^(k)(0) / k!, one column a power
};

// The same once.
Vec taylor_part(const Problem& problem, double t);

}  // namespace fde
