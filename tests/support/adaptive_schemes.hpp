// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "support/testing.hpp"

namespace fde::bench {

// The schemes with an adaptive step size.
inline std::vector<const Scheme*> adaptive_schemes() {
  auto some = all_schemes();
  std::erase_if(some, [](const Scheme* scheme) { return !scheme->capabilities.is_adaptive(); });
  return some;
}

}  // namespace fde::bench
