// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/special_functions/laplace/enclosed_transform.hpp"

namespace fde::reference {

// E^gamma_{alpha,beta}(z) is the inverse Laplace transform at time 1 of
//   F(s) = s^(alpha gamma - beta) / (s^alpha - z)^gamma = s^-beta (1 - z s^-alpha)^-gamma.
struct PrabhakarArguments {
  BigReal alpha, beta, gamma;
  BigComplex z;

  [[nodiscard]] bool real() const { return imag_part<BigReal>(z) == 0; }
};

// Returns the arguments rounded to the current precision.
using ReadPrabhakar = std::function<PrabhakarArguments()>;

// The transform F. Its branch points are 0, unless all powers of s are nonnegative integers, and the s* with
// s*^alpha = z on the sheet |arg s*| <= pi, each with a cut to the left. Precondition: z != 0.
EnclosedTransform prabhakar_transform(const ReadPrabhakar& read);

// sum_k (gamma)_k z^k / (k! Gamma(alpha k + beta)), with a bound of the rounding and truncation errors. A
// polynomial for gamma = 0, -1, -2, ...; otherwise the terms decay for |z| <= 0.4 max(1, beta)^alpha. Throws
// std::runtime_error if it takes too many terms.
BoundedSum<BigReal> prabhakar_series(const PrabhakarArguments& x);

}  // namespace fde::reference
