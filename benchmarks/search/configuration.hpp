// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

// A configuration of a search: a scheme with a grading of its grid, or a scheme with adaptive step size.
// The number of steps or the tolerance is free.
struct Configuration {
  const Scheme* scheme = nullptr;
  double grading = 1.0;

  [[nodiscard]] bool is_adaptive() const { return scheme->capabilities.is_adaptive(); }
};

}  // namespace fde::bench
