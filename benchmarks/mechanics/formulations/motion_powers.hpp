// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/mechanics/layout.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde::bench::mechanics {

// The powers of t with which the motion of a nonlinear system under a constraint with memory starts, the same
// for all coordinates. They are all that may occur: the series itself is not computed.
struct MotionExponents {
  std::vector<double> velocity;   // includes 0 if v(0) is not 0
  std::vector<double> free_part;  // of z = P v, without 0
};

// How the reaction starts below order 1. singular: df/dw v(0) is not 0, and the reaction starts like
// t^-order; singular_with_varying_direction: moreover its direction df/dv depends on w, which starts like
// t^(1-order).
enum class ReactionStart { regular, singular, singular_with_varying_direction };

// 0 < order < 1. The part of v that the constraint determines depends on w = D^order q: v - v(0) starts like
// t^(1-order) if the reaction is singular, otherwise like t. z' has the powers of v and q; a reaction of
// varying direction adds t^-order t^(1-order).
MotionExponents powers_below_one(double order, bool moving, ReactionStart reaction);

// 1 < order < 2, constant constraint: D^(order-1) (b.v) = -c - a.v is 0 at the start, so v - v(0) starts like
// t, and further powers follow in steps of 1 and order - 1.
MotionExponents powers_above_one(double order, bool moving);

// The smoothness of the rows of the formulations below order 1. In the state, s = D^order v lacks its part
// t^(1 - 2 order).
Smoothness integrated_start(const MotionExponents& powers, double order, const Layout& layout);
Smoothness acceleration_start(const MotionExponents& powers, double order, const Layout& layout,
                              bool singular);

// The same above order 1.
Smoothness integrated_start_above_one(const MotionExponents& powers, double order, const Layout& layout);

}  // namespace fde::bench::mechanics
