// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

#include "support/testing.hpp"

namespace fde::bench {

inline constexpr std::array both_schemes{"product_trapezoidal", "grunwald_letnikov"};

// Largest error of any column at any time.
inline double largest_error(const Scene& scene, std::string_view scheme, int steps) {
  const auto path = solve(scheme, scene.problem, steps);
  EXPECT_EQ(path.status, SolveStatus::finished);
  MemoizedReference reference(scene);
  return (columns_of(scene.outputs, path) - reference.at(path.times)).cwiseAbs().maxCoeff();
}

}  // namespace fde::bench
