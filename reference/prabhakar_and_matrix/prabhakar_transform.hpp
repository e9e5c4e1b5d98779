#pragma once

#include "laplace/enclosed_transform.hpp"

namespace fde {

// E^gamma_{alpha,beta}(z) is the inverse Laplace transform at time 1 of
//   F(s) = s^(alpha gamma - beta) / (s^alpha - z)^gamma = s^-beta (1 - z s^-alpha)^-gamma.
struct PrabhakarArguments {
  BigReal alpha, beta, gamma;
  BigComplex z;

  [[nodiscard]] bool real() const { return imag_part<BigReal>(z) == 0; }
};

// Reads the arguments at the precision in force.
using ReadPrabhakar = std::function<PrabhakarArguments()>;

// Its branch points are 0, unless all powers of s are whole and positive, and the s* with s*^alpha = z on the
// sheet |arg s*| <= pi, each with a cut to the left. z is not 0.
EnclosedTransform prabhakar_transform(const ReadPrabhakar& read);

// sum_k (gamma)_k z^k / (k! Gamma(alpha k + beta)), and what rounding and the terms left out may be off by.
// For gamma = 0, -1, -2, ... a polynomial; else |z| below 0.4 max(1, beta)^alpha, for terms that fall. Throws
// std::runtime_error when there are too many.
Sum<BigReal> prabhakar_series(const PrabhakarArguments& x);

}  // namespace fde
