#pragma once

#include <optional>

#include "certificate/ball.hpp"

namespace fde::certificate {

// E_{alpha,beta}(z), each argument exact or itself a ball.
struct Arguments {
  Ball alpha, beta, z;
  [[nodiscard]] bool real() const { return beta.is_real() && z.is_real(); }
};

enum class Method { automatic, power_series, residues, hankel };

// Encloses E_{alpha,beta}(z) = sum_k z^k / Gamma(alpha k + beta), alpha in (0, 5], real beta, with at least
// that many correct decimal digits relative to |E|. No formula is shared with the library: the power series
// with a geometric bound of its tail, the finite sum of residues where alpha and beta are whole, and else two
// rays and an arc in the logarithmic plane, integrated by Arb with a rigorous bound.
// Throws std::runtime_error when the accuracy is out of reach of 20000 bits, as at a zero.
Ball enclose(double alpha, double beta, std::complex<double> z, int digits,
             Method method = Method::automatic);
Ball enclose(const Arguments& x, int digits, Method method = Method::automatic);

// One attempt of each method at the working precision of this thread.
Ball power_series(const Arguments& x);
Ball whole_residues(const Arguments& x);   // alpha and beta whole, z not 0
Ball hankel_integral(const Arguments& x);  // z not 0

// Estimates that choose the method: terms the series needs for those bits, and bits it loses.
struct SeriesEffort {
  double terms, lost_bits;
};
SeriesEffort series_effort(const Arguments& x, long bits);

}  // namespace fde::certificate
