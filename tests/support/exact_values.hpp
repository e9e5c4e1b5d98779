// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include "fdebench/reference/reference.hpp"

namespace fde::bench {

// The reference at t is the exact solution within its bound, which is at most most_bound.
inline void expect_exact(const reference::Reference& reference, double t, const Vec& exact,
                         double most_bound) {
  const auto [value, bound] = reference.at(t);
  for (Eigen::Index i = 0; i < exact.size(); ++i) {
    EXPECT_NEAR(value[i], exact[i], bound[i]) << "t = " << t;
    EXPECT_LE(bound[i], most_bound) << "t = " << t;
  }
}

}  // namespace fde::bench
