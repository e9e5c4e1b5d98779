// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace fde::bench {

// The row of a table with the largest ratio of error to tolerance, for one assertion over all rows.
struct WorstRow {
  double ratio = 0.0;
  std::string row;

  void update(double error, double allowed, const std::string& name) {
    const double now = error == 0.0 ? 0.0 : error / allowed;
    if (!(now <= ratio)) *this = {now, fmt::format("{}: error {:.3g}, allowed {:.3g}", name, error, allowed)};
  }
  void update(double value, double exact, double allowed, const std::string& name) {
    update(std::abs(value - exact), allowed, fmt::format("{}: {:.17g} for {:.17g}", name, value, exact));
  }
};

inline void expect_within(const WorstRow& worst) { EXPECT_LE(worst.ratio, 1.0) << worst.row; }

}  // namespace fde::bench
