// SPDX-License-Identifier: MIT
#pragma once

#include "certificate/ball.hpp"

namespace fde::reference::certificate {

// Arguments of E_{alpha,beta}(z), each exact or an enclosure.
struct Arguments {
  Ball alpha, beta, z;
  [[nodiscard]] bool real() const { return beta.is_real() && z.is_real(); }
};

enum class Method { automatic, power_series, residues, hankel };

// Encloses E_{alpha,beta}(z) = sum_k z^k / Gamma(alpha k + beta), alpha in (0, 5], real beta, with at least
// `digits` correct decimal digits relative to |E|. Shares no formula with the library: the power series with
// a geometric bound of its tail, the finite sum of residues for integer alpha and beta, and otherwise
// Hankel's integral over two rays and an arc in the logarithmic plane, integrated by Arb with a rigorous
// bound. Throws std::runtime_error where 20000 bits do not suffice, as at a zero.
Ball enclose(double alpha, double beta, std::complex<double> z, int digits,
             Method method = Method::automatic);
Ball enclose(const Arguments& x, int digits, Method method = Method::automatic);

// One evaluation by each method at the working precision of this thread.
Ball power_series(const Arguments& x);
Ball integer_residues(const Arguments& x);  // alpha and beta integers, z != 0
Ball hankel_integral(const Arguments& x);   // z != 0

// Estimates for the choice of the method: terms that the series needs for `bits` bits, and bits lost by
// cancellation.
struct SeriesEffort {
  double terms, lost_bits;
};
SeriesEffort series_effort(const Arguments& x, long bits);

}  // namespace fde::reference::certificate
