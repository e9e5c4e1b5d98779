// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/adaptive/blow_up_detector.hpp"

#include <cmath>
#include <limits>

namespace fde {

BlowUpDetector::BlowUpDetector(In start)
    : largest_(start.cwiseAbs()),
      doubled_at_(Vec::Zero(start.size())),
      doubling_time_(Vec::Constant(start.size(), std::numeric_limits<double>::infinity())),
      faster_doublings_(doubled_at_) {}

void BlowUpDetector::accept_step(double t, In y) {
  constexpr double sooner = 0.75;  // of the previous duration: doublings are detected at the ends of steps
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const double size = std::abs(y[i]), took = t - doubled_at_[i];
    if (size < 2.0 * largest_[i]) continue;
    faster_doublings_[i] = took <= sooner * doubling_time_[i] ? faster_doublings_[i] + 1.0 : 0.0;
    doubling_time_[i] = took;
    doubled_at_[i] = t;
    largest_[i] = size;
  }
}

bool BlowUpDetector::is_near(double t) const {
  constexpr double several = 4.0, small_part = 1e-6;
  for (Eigen::Index i = 0; i < faster_doublings_.size(); ++i) {
    if (faster_doublings_[i] >= several && doubling_time_[i] <= small_part * t &&
        t - doubled_at_[i] <= doubling_time_[i])
      return true;
  }
  return false;
}

}  // namespace fde
