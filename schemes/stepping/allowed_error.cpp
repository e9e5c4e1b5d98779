#include "stepping/allowed_error.hpp"

#include <limits>

namespace fde {

namespace {

Eigen::ArrayXd noise(In largest, In terms) {
  constexpr double above_rounding = 50.0 * std::numeric_limits<double>::epsilon();
  // Below, doubles lose their digits one by one, and Newton's method does not converge to part of them.
  constexpr double smallest = std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();
  return (above_rounding * terms.array().max(largest.array())).max(smallest);
}

}  // namespace

Vec AllowedError::of(In largest, In terms) const {
  constexpr double of_row = 0.01;
  if (largest_.size() == 0) return of_accuracy(largest, terms);
  const Eigen::ArrayXd asked = accuracy_.absolute + accuracy_.relative * largest.array();
  return asked.min(of_row * largest.array().max(largest_.array())).max(noise(largest, terms));
}

Vec AllowedError::of_accuracy(In largest, In terms) const {
  return (accuracy_.absolute + accuracy_.relative * largest.array()).max(noise(largest, terms));
}

void AllowedError::pass(In largest) {
  if (largest_.size() == 0) largest_ = largest;
  largest_ = largest_.cwiseMax(largest);
}

}  // namespace fde
