#pragma once

#include <array>
#include <optional>

#include "history/running_sum.hpp"
#include "scenes/scene.hpp"

namespace fde {

// max_n |E(t_n) - E(0) - int_0^(t_n) power dt|, step after step: nothing of the path is kept. The integral is
// that of the parabola through the last three steps, of third order, which is more than any scheme here has.
class EnergyObserver {
 public:
  explicit EnergyObserver(const Energy& energy) : energy_(energy) {}

  // Takes the steps 0, 1, 2, ... in order.
  void observe(double t, In y);

  // Nothing before three steps. Not finite where an energy was not.
  [[nodiscard]] std::optional<double> residual() const;

 private:
  struct Point {
    double t, energy, power;
  };
  void compare(const Point& at);

  const Energy& energy_;
  std::array<Point, 3> last_{};
  int seen_ = 0;
  double start_ = 0.0, largest_ = 0.0;
  RunningSums work_{1};
};

}  // namespace fde
