// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/reference/special_functions/laplace/enclosing_contour.hpp"

namespace fde::reference {

// Enclosing contours by ascending height, one for each group of singularities at about the same height. The
// inverse transform is the sum of the integrals along them: with cuts to the left, the path of integration
// runs to the left and back between two groups, where e^s is negligible. Their rectangles do not overlap. The
// work does not depend on the distances between the groups. Throws std::runtime_error where |Im s*| is so
// large that long double does not resolve the distances of s* from its contour.
std::vector<EnclosingContour> separate_contours(const std::vector<EnclosingContour::Point>& singularities,
                                                int digits, const EnclosingContour::Hints& hints);

}  // namespace fde::reference
