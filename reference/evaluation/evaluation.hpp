#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "numbers/bounded.hpp"
#include "reference.hpp"

namespace fde {

// Real columns as functions of time: what a reference is made of.
struct Evaluation {
  std::string name;  // begins the messages
  // In long double, rounded to double; empty where that is not accurate enough. Left out where it never is.
  std::function<std::optional<std::vector<DoubleBounded>>(double t)> quick{};
  // Each column to a relative accuracy of so many digits, under a Precision that the caller has set.
  std::function<std::vector<Bounded<BigReal>>(double t, int digits)> precise;
  double end = std::numeric_limits<double>::infinity();  // times are finite and in [0, end]
};

// The columns at a time: quick, and where that does not do, rounded from as many digits as a double needs.
std::vector<DoubleBounded> in_double(const Evaluation& evaluation, double t);

// Both functions of the reference throw std::invalid_argument for a time outside [0, end] or not finite, and
// the second one for fewer digits than 1.
Reference as_reference(const Evaluation& evaluation);

}  // namespace fde
