// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/schemes/history/running_sum.hpp"

namespace fde::bench {

// max_n |E(t_n) - E(0) - int_0^(t_n) power dt - sum_k int_0^(t_n) c_k dx_k|, with x_k the columns
// `differentiated_columns` of the Energy and c_k its `rate_coefficients`, accumulated step by step without
// storing the path. The integrals are those of the parabola through the last three steps, of third order,
// which is higher than the rate of any scheme here. If the c_k are affine in x, the second integral is exact
// at any step size, also at the singular start of a reaction.
class EnergyObserver {
 public:
  // `energy` must outlive this object.
  explicit EnergyObserver(const Energy& energy) : energy_(energy) {}

  // Called after steps 0, 1, 2, ... in order.
  void observe(double t, In columns);

  // nullopt before three steps. Not finite if an energy was not.
  [[nodiscard]] std::optional<double> residual() const;

 private:
  struct Point {
    double t = 0.0, energy = 0.0, power = 0.0;
    Vec rate_coefficients{}, differentiated_columns{};
  };
  [[nodiscard]] Point point_at(double t, In columns) const;
  void compare(const Point& at);

  const Energy& energy_;
  std::array<Point, 3> last_{};
  int step_count_ = 0;
  double start_ = 0.0, largest_ = 0.0;
  RunningSums work_{1};
};

}  // namespace fde::bench
