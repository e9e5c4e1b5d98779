#pragma once

#include "problem/vectors.hpp"

namespace fde {

// 1/Gamma(order) int (z - x)^(order-1) P_l(x) dx over -1 < x < min(z, 1), l = 0 ... count - 1: what a
// function with these Legendre polynomials on [-1, 1] adds to its fractional integral at z = 1 + beyond. One
// row a point; beyond >= -2, order > 0.
//
// With a = order - 1 the integrals obey (l+2+a) m_(l+1) = (2l+1) z m_l - (l-1-a) m_(l-1), l >= 1, as the
// derivative of P_(l+1) - P_(l-1) is (2l+1) P_l. Beyond the panel they are the solution that falls fastest.
Matrix kernel_moments(double order, const Vec& beyond, Eigen::Index count);

// Those at z = -1 + since on [-1, 1], 0 <= since <= 2, as good next to the start as elsewhere: relative to
// since^order.
Vec own_moments(double order, double since, Eigen::Index count);

}  // namespace fde
