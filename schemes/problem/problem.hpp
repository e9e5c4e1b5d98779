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

// One unknown y_i with the order gamma_i > 0 of its Caputo derivative from t = 0.
struct Component {
  double order;
  std::vector<double> initial;  // initial[k] = y^(k)(0) for k < ceil(order)
};

// A multi-order system D^(gamma_i) y_i = f_i(t, y), 0 < t <= end.
struct Problem {
  std::vector<Component> components{};
  std::function<void(double t, In y, Out f)> rhs{};
  std::function<void(double t, In y, OutMatrix jacobian)>
      jacobian{};                       // df/dy; empty: implicit schemes difference rhs
  std::optional<Matrix> linear_part{};  // A, where f(t, y) = A y + b(t): solved with one factorisation
  double end = 1.0;

  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(components.size()); }
};

// Number of initial values that a Caputo derivative of this order needs: ceil(order).
std::size_t initial_count(double order);

// Taylor part sum_k y^(k)(0) t^k / k! of every component, up to k < ceil(order).
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
