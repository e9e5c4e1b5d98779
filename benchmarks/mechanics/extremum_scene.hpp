// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/mechanics/mechanical_system.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench::mechanics {

// The ends of an extremum: q(0) and, for each coordinate, q(T) or nullopt, where the end is free. Without any
// of these values given and without memory terms the extremum starts from q(0), q'(0) and the multipliers
// mu(0).
struct ExtremumEnds {
  std::vector<std::optional<double>> final{};
  Vec multipliers{};
};

// The extremum of int (L + mu f) dt, with L and f functions of t, q, v and w = D^a q, a < 1, and f affine in
// v (Agrawal 2002; Tarasov & Zaslavsky 67, 70, 79-86 corrected). With L* = L + mu f, p = dL*/dv and pi_k =
// dL*/dw_k,
//   P = p + sum_k r_k,  P' = dL*/dq + F,  r_k = J_-^(1-a) pi_k,  v = G^-1 (p - dL/dv(v = 0) - (df/dv)^T mu),
//   f = 0.
// The adjoint of a left Caputo derivative is the right Riemann-Liouville derivative -d/dt J_-^(1-a), so that
// P has a regular right-hand side, and r_k is a right row: tD_T^(1-a) r_k = pi_k, r_k(T) = 0. Where an end is
// free, P(T) = 0. Without memory terms and given ends this is the conditional extremum with initial values.
//
// The columns are q, v and w with the given names. Throws std::invalid_argument if d^2 L/dv^2 is singular at
// t = 0 or depends on v, and ConstraintError for a constraint.
Scene extremum_scene(const MechanicalSystem& system, const ExtremumEnds& ends,
                     const std::vector<std::string>& names, double end, ExpressionPool& pool);

}  // namespace fde::bench::mechanics
