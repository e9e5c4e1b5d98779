// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/history/weights/weights.hpp"
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

// The weights of one interval in a fractional integral of order g with a linear integrand u:
//   1/Gamma(g) int_a^b (t - s)^(g-1) u(s) ds = left u(a) + right u(b),  t >= b.
// Accurate to a few units in the last place for every g in (0, 2], also for intervals that are short compared
// to t - b.
struct IntervalWeights {
  double left, right;
};

// The weights for order g. Preconditions: distance = t - b >= 0, length = b - a > 0.
IntervalWeights interval_weights(double order, double distance, double length);

// The order with which a rule of this table integrates: g where it integrates f, 1 - g for the slope of y.
double integral_order(const WeightTable& table);

// The factor from the integral up to the end of a step of this length to the memory sum, in which the newest
// sample has weight 1: 1/step_factor where f is integrated, step_factor where the slope of y is.
double integral_to_sum_factor(const WeightTable& table, double length);

}  // namespace fde
