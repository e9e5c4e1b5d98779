// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/start_weights/decaying_weights.hpp"

#include <algorithm>
#include <cmath>

namespace fde {

Matrix DecayingWeights::rows(Eigen::Index first, Eigen::Index most) const {
  constexpr double negligible = 1e-19;
  constexpr Eigen::Index together = 32;
  Vec powers(terms.rows());
  for (Eigen::Index k = 0; k < powers.size(); ++k)
    powers[k] = std::pow(static_cast<double>(first), -static_cast<double>(k));
  const double size = (powers.transpose() * terms.cwiseAbs()).maxCoeff();
  const double last = std::log(negligible / std::max(negligible, size)) / decay.real();
  const auto needed = (static_cast<Eigen::Index>(last) - first + together) / together * together;
  ComplexMatrix factors(std::clamp<Eigen::Index>(needed, 0, most), terms.rows());
  for (Eigen::Index i = 0; i < factors.rows(); ++i) {
    const auto n = static_cast<double>(first + i + 1);
    std::complex<double> factor = std::pow(n, power) * std::exp(n * decay);
    for (Eigen::Index k = 0; k < factors.cols(); ++k) {
      factors(i, k) = factor;
      factor /= n;
    }
  }
  return factors.real() * terms.real() - factors.imag() * terms.imag();
}

}  // namespace fde
