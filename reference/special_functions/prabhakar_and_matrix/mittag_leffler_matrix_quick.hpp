// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "fdebench/reference/special_functions/mittag_leffler/quick.hpp"

namespace fde::reference {

// E_{alpha,beta}(A) of a small matrix in double-double, row by row: the adjugate (adjugate.hpp) of
// s^alpha - A gives one sum over the nodes of a contour for each power of s^alpha. All s* of the eigenvalues
// are left of the contour. Errors are bounded in every step; bounds of p on the contour come from approximate
// eigenvalues and from the distance of p to the polynomial with these zeros. nullopt where an error is above
// quick_tolerance of its entry.
inline constexpr int max_quick_rows = 4;
std::optional<std::vector<QuickValue>> mittag_leffler_matrix_quick(double alpha, double beta,
                                                                   const Eigen::MatrixXcd& matrix);

}  // namespace fde::reference
