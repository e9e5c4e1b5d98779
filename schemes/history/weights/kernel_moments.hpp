// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// The fractional integrals of the Legendre polynomials on [-1, 1] at the points z = 1 + beyond:
//   m_l = 1/Gamma(order) int (z - x)^(order-1) P_l(x) dx over -1 < x < min(z, 1), l = 0 ... count - 1.
// One row a point, one column a polynomial. Preconditions: beyond >= -2, order > 0.
//
// With a = order - 1 they satisfy (l+2+a) m_(l+1) = (2l+1) z m_l - (l-1-a) m_(l-1), l >= 1, because the
// derivative of P_(l+1) - P_(l-1) is (2l+1) P_l. For z > 1 they are the minimal solution of this recurrence.
Matrix kernel_moments(double order, const Vec& beyond, Eigen::Index count);

// The m_l at one point z = -1 + since, 0 <= since <= 2, with an error relative to since^order also for small
// since.
Vec moments_inside_panel(double order, double since, Eigen::Index count);

}  // namespace fde
