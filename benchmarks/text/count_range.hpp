// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace fde::bench {

// Allowed whole numbers, both ends among them.
struct CountRange {
  int lowest = 0, highest = 0;

  [[nodiscard]] std::string text() const;  // "a whole number from 1 to 100"
};

}  // namespace fde::bench
