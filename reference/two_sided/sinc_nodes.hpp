// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/two_sided/nodal_basis.hpp"

namespace fde::reference {

// Sinc basis in x with t = 1 / (1 + e^(-pi sinh x)): functions of t that start and end like a small power,
// minus the straight line between their end values, decay doubly exponentially in x and are sums of
// sinc(x/step - j) (F. Stenger, Numerical Methods Based on Sinc and Analytic Functions, 1993; the map: H.
// Takahasi & M. Mori, 1974). Integrals are computed by the trapezoidal rule after the same map.
NodalBasis sinc_nodes(double step);

}  // namespace fde::reference
