// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/schemes/problem/archive.hpp"

namespace fde::bench {

// The columns of a run at some of its times, collected during the solve, so that the states, up to a million,
// need not be stored. The requested times increase and are times of steps up to rounding; an empty list means
// all steps.
class RetainedColumns {
 public:
  // For a run that computes y / unit. `outputs` must outlive this object.
  RetainedColumns(const Outputs& outputs, std::vector<double> times, double unit = 1.0);

  // Called after every step.
  void observe(double t, In y);

  // Saves or restores the collected columns, for a run that is interrupted and resumed.
  void state(Archive& archive);

  [[nodiscard]] const std::vector<double>& times() const { return times_; }
  // One column a time.
  [[nodiscard]] Rows columns() const { return columns_.leftCols(std::ssize(times_)); }

 private:
  [[nodiscard]] bool is_requested(double t);

  const Outputs& outputs_;
  std::vector<double> requested_, times_;
  double unit_;
  std::size_t next_ = 0;    // index of the next requested time
  double next_from_ = 0.0;  // is_requested() is false before this time
  Rows columns_;
};

}  // namespace fde::bench
