// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace fde::bench {

// Progress of a long computation. If its part is unknown, it is 0, and so is the total.
struct Progress {
  double part = 0.0;  // finished fraction, in [0, 1]
  std::size_t done = 0, total = 0;
  std::optional<double> seconds_left{};
  std::string current_run{};
};

}  // namespace fde::bench
