#pragma once

#include <optional>
#include <vector>

#include "mittag_leffler/quick.hpp"
#include "problem/problem.hpp"

namespace fde {

// E_{alpha,beta}(A) of a small matrix in double-double, row by row:
//   (x - A)^-1 = sum_j x^j N_j / p(x),  p(x) = det(x - A),  x = s^alpha
// leaves one sum over the nodes of a contour for each j. The N_j are constant (Faddeev and Le Verrier;
// Gantmacher, The Theory of Matrices, chapter 4). Every eigenvalue has its s* left of the contour. The error
// of every step is counted; bounds of p on the contour come from approximate eigenvalues and from how far
// the polynomial that has them is from p. Empty where an error is above quick_tolerance of its entry.
inline constexpr int most_quick_rows = 4;
std::optional<std::vector<QuickValue>> mittag_leffler_matrix_quick(double alpha, double beta,
                                                                   const ComplexMatrix& matrix);

}  // namespace fde
