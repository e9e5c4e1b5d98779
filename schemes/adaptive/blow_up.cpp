#include "adaptive/blow_up.hpp"

#include <cmath>
#include <limits>

namespace fde {

BlowUp::BlowUp(In start)
    : largest_(start.cwiseAbs()),
      doubled_at_(Vec::Zero(start.size())),
      took_(Vec::Constant(start.size(), std::numeric_limits<double>::infinity())),
      sooner_(doubled_at_) {}

void BlowUp::pass(double t, In y) {
  constexpr double sooner = 0.75;  // of the previous duration: doublings are detected at the ends of steps
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const double size = std::abs(y[i]), took = t - doubled_at_[i];
    if (size < 2.0 * largest_[i]) continue;
    sooner_[i] = took <= sooner * took_[i] ? sooner_[i] + 1.0 : 0.0;
    took_[i] = took;
    doubled_at_[i] = t;
    largest_[i] = size;
  }
}

bool BlowUp::is_near(double t) const {
  constexpr double several = 4.0, small_part = 1e-6;
  for (Eigen::Index i = 0; i < sooner_.size(); ++i) {
    if (sooner_[i] >= several && took_[i] <= small_part * t && t - doubled_at_[i] <= took_[i]) return true;
  }
  return false;
}

}  // namespace fde
