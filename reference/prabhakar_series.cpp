#include "prabhakar_transform.hpp"

namespace fde {

Sum<BigReal> prabhakar_series(const PrabhakarArguments<BigReal>& x) {
  Sum<BigReal> sum;
  BigComplex factor(1);  // (gamma)_k z^k / k!
  const BigReal size = abs(x.z);
  for (int k = 0;; ++k) {
    const BigReal argument = x.alpha * k + x.beta;
    const BigComplex term = factor * reciprocal_gamma(argument);
    const BigReal ulps = 8 + 8 * BigReal(k) + abs(argument) * (2 + 2 * log1p(abs(argument)));
    sum.add(term, BigReal(ulps * epsilon<BigReal>()));
    factor *= x.z * (x.gamma + k) / BigReal(k + 1);
    if (factor == 0) return sum;
    // From here on |(gamma)_k / k!| grows by less than ratio / |z|, and 1/Gamma falls.
    const BigReal next = x.gamma + k + 1;
    const BigReal ratio = size * std::max(BigReal(1), BigReal(abs(next) / (k + 2)));
    if (argument < 2 || next <= 0 || ratio > 0.9) continue;
    const BigReal tail = size_of(factor) * reciprocal_gamma(argument) / (1 - ratio);
    if (tail > epsilon<BigReal>() * size_of(sum.value)) continue;
    sum.error += tail;
    return sum;
  }
}

}  // namespace fde
