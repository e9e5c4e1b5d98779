// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace fde::bench {

// A quantity as a function of time, at increasing times.
struct Course {
  std::vector<double> t{}, value{};

  [[nodiscard]] bool empty() const { return t.empty(); }
  bool operator==(const Course&) const = default;
};

}  // namespace fde::bench
