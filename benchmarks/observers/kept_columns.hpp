#pragma once

#include <vector>

#include "checkpoint/archive.hpp"
#include "scenes/scene.hpp"

namespace fde {

// The columns of a run at some of its times, taken while it steps: the states, of which there may be a
// million, need not be kept. Times are increasing and those of the steps up to rounding; none: all steps.
class KeptColumns {
 public:
  // The run computes y / unit.
  KeptColumns(const Outputs& outputs, std::vector<double> times, double unit = 1.0);

  // Hears every step.
  void observe(double t, In y);

  // What it has kept, of a run that is ended and continued.
  void state(Archive& archive);

  [[nodiscard]] const std::vector<double>& times() const { return times_; }
  // One column a time.
  [[nodiscard]] Rows columns() const { return columns_.leftCols(std::ssize(times_)); }

 private:
  [[nodiscard]] bool asked_for(double t);

  const Outputs& outputs_;
  std::vector<double> asked_, times_;
  double unit_;
  std::size_t next_ = 0;  // of those asked for
  Rows columns_;
};

}  // namespace fde
