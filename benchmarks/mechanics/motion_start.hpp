// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <stdexcept>
#include <string>

#include "fdebench/benchmarks/mechanics/dynamics.hpp"

namespace fde::bench::mechanics {

// The directions c_k of the unbounded part sum_k c_k t^-a_k / Gamma(1 - a_k) of v' at t = 0, by order a_k < 1
// of the memory terms of the constraints. It is due to w' = D^a v + t^-a / Gamma(1-a) v(0) (Tarasov &
// Zaslavsky 23). A sum within rounding of 0 counts as 0; orders with c = 0 are left out.
std::map<double, Vec> singular_directions(const Dynamics& dynamics);

// How the reaction of constraints with orders below 1 starts. singular: some c_k is not 0;
// singular_with_varying_direction: moreover the direction df/dv depends on v or w, which leave their initial
// values like t^(1 - a).
enum class ReactionStart { regular, singular, singular_with_varying_direction };
ReactionStart reaction_start(const Dynamics& dynamics);

// v(0) after an immediate jump along the reaction, for constraints with memory terms of order 1, where a v(0)
// with f != 0 must jump. It is the limit from below: for order < 1, w(0) = 0, and as the order tends to 1, w
// approaches v ever faster.
Vec consistent_velocity(const Dynamics& dynamics);

// lambda(0) as a guess: 0 if it is unbounded.
Vec initial_multiplier(const Dynamics& dynamics);

// The velocity nearest to v(0), in the metric of L, with which all constraints hold at t = 0: with w = 0, or
// with w = v in terms of order 1 where that velocity is nearer. v(0) itself if there is none.
Vec projected_velocity(const Dynamics& dynamics);

// Newton's method for the constraints at a fixed place, from the velocity v: step(v) is its step, along the
// reaction.
Vec velocity_on_constraints(Vec velocity, const std::function<Vec(const Vec& velocity)>& step);

// The value of expressions of t and the columns at t = 0.
Vec at_start(const Dynamics& dynamics, const Expressions& of);

// An error in the constraint of this number, from 0.
struct ConstraintError : std::invalid_argument {
  ConstraintError(std::size_t number, const std::string& what)
      : std::invalid_argument(what), constraint(number) {}
  std::size_t constraint;
};

// The same where a constraint is not 0 at t = 0 with the initial velocities.
struct StartError : ConstraintError {
  using ConstraintError::ConstraintError;
};

// Throws std::invalid_argument if the metric is singular at t = 0, and ConstraintError if a constraint has no
// reaction there or depends on those before it.
void require_regular_start(const Dynamics& dynamics);

// Throws StartError, with the nearest velocity that keeps all constraints, if one is not 0 at t = 0:
// with w = 0, or with w = v in terms of order 1.
void require_start_on_constraints(const Dynamics& dynamics);

}  // namespace fde::bench::mechanics
