#include "stepping/allowed_error.hpp"

#include <limits>

namespace fde {

namespace {

// What the rounding of terms, and of a row that is so large, may leave.
Eigen::ArrayXd noise(const Eigen::ArrayXd& largest, In terms) {
  constexpr double above_rounding = 50.0 * std::numeric_limits<double>::epsilon();
  // Below, doubles lose their digits one by one, and Newton's method does not converge to part of them.
  constexpr double smallest = std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();
  return (above_rounding * largest.max(terms.array())).max(smallest);
}

}  // namespace

Vec AllowedError::of(In least, In largest, In terms) const {
  constexpr double of_row = 0.01;
  constexpr double counts = 1e-3, growth = 16.0;  // of the relative error; of a row on a step
  const bool by_least = accuracy_.absolute > counts * accuracy_.relative;
  const Eigen::ArrayXd size = by_least ? least.array() : largest.array();
  const Eigen::ArrayXd asked = accuracy_.absolute + accuracy_.relative * size;
  Eigen::ArrayXd rounded = largest.array();
  if (by_least) rounded = rounded.min(growth / accuracy_.relative * asked);
  const Eigen::ArrayXd rounding = noise(rounded, terms);
  if (largest_.size() == 0) return asked.max(rounding);
  return asked.min(of_row * largest.array().max(largest_.array())).max(rounding);
}

Vec AllowedError::of_accuracy(In largest, In terms) const {
  return (accuracy_.absolute + accuracy_.relative * largest.array()).max(noise(largest.array(), terms));
}

void AllowedError::pass(In largest) {
  if (largest_.size() == 0) largest_ = largest;
  largest_ = largest_.cwiseMax(largest);
}

}  // namespace fde
