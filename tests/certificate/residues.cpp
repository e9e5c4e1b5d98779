// SPDX-License-Identifier: MIT
#include <cmath>

#include "certificate/enclosure.hpp"

namespace fde::reference::certificate {

// For integers alpha = n and beta the integrand of Hankel's integral has no branch cut, so E is the sum of
// its residues at the n roots s^n = z, e^s s^(1-beta)/n, and at 0, - sum_{j>=1} z^-j / Gamma(beta - n j).
Ball integer_residues(const Arguments& x) {
  const int roots = static_cast<int>(std::lround(x.alpha.mid().real()));
  const long beta = std::lround(x.beta.mid().real());
  Ball sum;
  for (int k = 0; k < roots; ++k) {
    const Ball u = (log(x.z) + Ball::i() * Ball::pi() * Ball(2.0 * k)) / x.alpha;
    sum = sum + exp(exp(u) + (Ball(1.0) - x.beta) * u) / x.alpha;
  }
  Ball power(1.0);
  for (long top = beta - roots; top >= 1; top -= roots) {
    power = power / x.z;
    sum = sum - power * reciprocal_gamma(Ball(static_cast<double>(top)));
  }
  return sum;
}

}  // namespace fde::reference::certificate
