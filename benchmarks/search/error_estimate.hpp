// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "fdebench/benchmarks/search/configuration.hpp"

namespace fde::bench {

// An error estimate for a scene without a reference: two runs of different schemes, the second with half the
// steps, so that an error common to both rules shows in their difference too. The first, finer run replaces
// the reference. The estimate is no bound.
struct ErrorEstimate {
  std::string no_reference_reason{};  // why there is no reference
  Configuration first{}, second{};    // `first` replaces the reference
  int first_steps = 0, second_steps = 0;
  double difference = 0.0;  // largest over the compared columns, on the scale of the target
  double factor = 0.0;      // estimated error of the first run = factor * difference

  [[nodiscard]] double error() const { return factor * difference; }
};

}  // namespace fde::bench
