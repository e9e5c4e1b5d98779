#include "stepping/allowed_error.hpp"

#include <limits>

namespace fde {

Vec AllowedError::of(In largest, In terms) const {
  constexpr double above_rounding = 50.0 * std::numeric_limits<double>::epsilon(), of_row = 0.01;
  const Eigen::ArrayXd asked = accuracy_.absolute + accuracy_.relative * largest.array();
  // Below, doubles lose their digits one by one, and Newton's method does not converge to part of them.
  constexpr double smallest = std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();
  const Eigen::ArrayXd noise = (above_rounding * terms.array().max(largest.array())).max(smallest);
  if (largest_.size() == 0) return asked.max(noise);
  return asked.min(of_row * largest.array().max(largest_.array())).max(noise);
}

void AllowedError::pass(In largest) {
  if (largest_.size() == 0) largest_ = largest;
  largest_ = largest_.cwiseMax(largest);
}

}  // namespace fde
