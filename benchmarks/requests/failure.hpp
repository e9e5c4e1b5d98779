// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace fde::bench {

// A scheme or a reference failed before the end time.
struct NumericalFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace fde::bench
