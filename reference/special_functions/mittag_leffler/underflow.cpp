// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/mittag_leffler/underflow.hpp"

#include <algorithm>
#include <cmath>

#include "fdebench/reference/special_functions/laplace/contour_bound.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/quick_residues.hpp"

namespace fde::reference {
namespace {

constexpr double log_of_nothing = -750.0;  // half the smallest double is e^-745.1

// For beta >= 2, Gamma(beta + x) >= Gamma(beta) (beta-1)^x, so |E| <= 1/Gamma(beta) / (1-q) with
// q = |z| / (beta-1)^alpha. For alpha <= 1, E is int e^(z u) d mu(u) with a positive measure mu (Schneider
// 1996: complete monotonicity), so |E(z)| <= E(Re z), which increases with Re z.
bool vanishes_by_series(double alpha, double beta, std::complex<double> z) {
  const double size = alpha <= 1.0 ? std::max(z.real(), 0.0) : std::abs(z);
  return size <= 0.5 * std::pow(beta - 1.0, alpha);
}

// Residues are at most (1/alpha) e^(Re s*) |s*|^(1-beta).
double log_residue(const QuickArguments& x, const Pole<double>& pole) {
  constexpr double most_log = 600.0, rounding = 1e-14;  // of arg s*
  const double log_size = std::min(pole.log.real(), most_log);
  return std::exp(log_size) * (std::cos(pole.log.imag()) + rounding) + (1.0 - x.beta.hi) * log_size -
         std::log(x.alpha);
}

// Whether the integral along the parabola s = mu (1 + i x)^2 and the residues to its right are negligible.
bool vanishes_on(const QuickArguments& x, double mu) {
  constexpr double most_log = 600.0, log_of_poles = 3.0;
  PerSheet<std::complex<double>> roots;
  bool residues_vanish = true;
  for (const auto& pole : x.poles.on_near_sheets) {
    const double log_modulus = 0.5 * std::min(pole.log.real() - std::log(mu), most_log);
    roots.push_back(std::polar(std::exp(log_modulus), 0.5 * pole.log.imag()));
    if (ContourBound::includes_residue(roots.back(), 1.0))
      residues_vanish = residues_vanish && log_residue(x, pole) + log_of_poles < log_of_nothing;
  }
  return residues_vanish &&
         ContourBound::log_integral(mu, 1.0,
                                    {.exponent = x.alpha - x.beta.hi,
                                     .alpha = x.alpha,
                                     .log_size = x.log_size(),
                                     .nearest_other_argument = x.poles.nearest_other_argument,
                                     .roots = {roots.data(), roots.size()}}) < log_of_nothing;
}

}  // namespace

bool certainly_underflows(double alpha, double beta, std::complex<double> z) {
  constexpr double smallest = 180.0;  // 2 / Gamma(180) = 1e-327
  if (beta < smallest) return false;
  if (z == 0.0 || vanishes_by_series(alpha, beta, z)) return true;
  const QuickArguments x(alpha, {beta, 0.0}, z);
  // For s > 0, e^s s^-beta is smallest at s = beta. A pole may be too near one of these parabolas.
  return std::ranges::any_of(std::array{1.0, 0.25, 4.0},
                             [&](double part) { return vanishes_on(x, part * beta); });
}

}  // namespace fde::reference
