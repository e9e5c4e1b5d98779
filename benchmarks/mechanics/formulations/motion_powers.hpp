#pragma once

#include "mechanics/layout.hpp"
#include "problem/smoothness.hpp"

namespace fde::mechanics {

// The powers of t with which a motion under a constraint with memory starts, all coordinates alike: those
// of a nonlinear system, whose own series is not known.
struct MotionPowers {
  std::vector<double> velocity;   // 0 among them where v(0) is not 0
  std::vector<double> free_part;  // of z = P v, without 0
};

// How the reaction starts below order 1. singular: df/dw v(0) is not 0, and the reaction starts like
// t^-order; turning: its direction df/dv moves with w, which starts like t^(1-order).
enum class ReactionStart { regular, singular, singular_and_turning };

// 0 < order < 1. What the constraint fixes of v is driven by w = D^order q: it leaves v(0) like t^(1-order)
// where the reaction is singular, otherwise like t. z' is made of what v and q are made of; a reaction that
// turns adds t^-order t^(1-order).
MotionPowers powers_below_one(double order, bool moving, ReactionStart reaction);

// 1 < order < 2, constant constraint: D^(order-1) (b.v) = -c - a.v is 0 at the start, so that v leaves v(0)
// like t and goes on in steps of order - 1.
MotionPowers powers_above_one(double order, bool moving);

// How the rows of the formulations start below order 1. Of s = D^order v the state has no part
// t^(1 - 2 order).
Smoothness integrated_start(const MotionPowers& powers, double order, const Layout& layout);
Smoothness acceleration_start(const MotionPowers& powers, double order, const Layout& layout, bool singular);

// The same above order 1.
Smoothness integrated_start_above_one(const MotionPowers& powers, double order, const Layout& layout);

}  // namespace fde::mechanics
