// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/history/symbols/symbol.hpp"

namespace fde {

// The symbols of the rules for integrated equations (integrated_equations.hpp), one row and column an
// equation. With G the generating function of g / a of every equation, K_v = kappa_v W_(L-v), B the
// derivatives of g / a by the rows, and
//   D = 1 + sum_k c_k/a K_(a_k),   D D^v u = K_v G + data,
// S is
//   implicit    delta - sum_v B_v K_v / D
//   predicted   delta - sum_v B_v (K_v - kappa_v + kappa_v C) / D,   C = (1 + b)^-1 (1 + b zeta (2 - zeta)),
// C maps G to the generating function of g at the prediction, and b = sum_v B_v kappa_v / (1 + sum_k c_k/a
// kappa_k) is the weight of the newest g. Columns are multiplied by D (1-zeta)^L. A factor C before D becomes
// D^-1 C D, so that for coupled predicted equations a growing mode of D = 0 is taken for a pole. The
// determinant is multiplied by that of 1 + b: for one equation it is then a polynomial in B.
Symbol implicit_multi_term_symbol(const Problem& problem, const WeightFamily& family, double length);
Symbol predicted_multi_term_symbol(const Problem& problem, double length);

}  // namespace fde
