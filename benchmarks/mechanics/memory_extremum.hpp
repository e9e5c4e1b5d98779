// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/mechanics/extremum_scene.hpp"

namespace fde::bench::mechanics {

// Whether a Lagrangian contains no velocities but derivatives of one order of all coordinates.
bool is_memory_lagrangian(const MechanicalSystem& system, ExpressionPool& pool);

// The extremum of int L dt for such a Lagrangian of t, q and w = D^a q, 1/2 < a < 1, with H = d^2 L/dw^2
// constant and dL/dq without w (Agrawal 2002; Tarasov & Zaslavsky 70 corrected): tD_T^a pi = -dL/dq with pi =
// dL/dw = H w + g(t, q) and the right Riemann-Liouville derivative. In its kernel is (T-t)^(a-1), which is
// infinite at T. With the part
//   S(t) = (2a-1) T^(1-2a) int_0^t ((t-s)(T-s))^(a-1) ds
// of q that it causes, the rest of q and of pi is regular, and for it the derivative equals the Caputo
// derivative:
//   q = y + c S,  D^a y = H^-1 (pi - g),  tD_T^a pi = -dL/dq,  c' = 0,  y(T) + c = q(T).
// A free end has c = 0. The columns are q.
Scene memory_extremum_scene(const MechanicalSystem& system, const ExtremumEnds& ends,
                            const std::vector<std::string>& names, double end, ExpressionPool& pool);

}  // namespace fde::bench::mechanics
