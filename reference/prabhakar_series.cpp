#include <fmt/format.h>

#include <stdexcept>

#include "prabhakar_transform.hpp"

namespace fde {
namespace {

// A bound of the sum of the terms after the k-th, infinite where there is none yet; next is
// (gamma)_{k+1} z^{k+1} / (k+1)!. From there on |(gamma + k) / (k + 1)| is at most what it is there, or 1.
// And
//   Gamma(x + alpha) / Gamma(x) >= (x - 1)^alpha, for psi(x) >= log x - 1/x >= log(x - 1);  1/Gamma(x)
//   <= 1.13, x >= 0.
BigReal tail(const PrabhakarArguments& x, int k, const BigComplex& next) {
  const BigReal argument = x.alpha * (k + 1) + x.beta, growing = x.gamma + k + 1;
  const BigReal power = abs(x.z) * std::max(BigReal(1), BigReal(abs(growing) / (k + 2)));
  const BigReal ratio = argument < 2 ? power : BigReal(power * pow(BigReal(argument - 1), -x.alpha));
  if (argument < 0 || growing <= 0 || ratio > 0.9) return {std::numeric_limits<double>::infinity()};
  const BigReal first = argument < 2 ? BigReal(1.13) : reciprocal_gamma(argument);
  return size_of(next) * first / (1 - ratio);
}

}  // namespace

Sum<BigReal> prabhakar_series(const PrabhakarArguments& x) {
  constexpr int most_terms = 200000;
  Sum<BigReal> sum;
  BigComplex factor(1);  // (gamma)_k z^k / k!
  for (int k = 0; k < most_terms; ++k) {
    const BigReal argument = x.alpha * k + x.beta;
    const BigReal ulps = 8 + 8 * BigReal(k) + abs(argument) * (2 + 2 * log1p(abs(argument)));
    sum.add(BigComplex(factor * reciprocal_gamma(argument)), BigReal(ulps * epsilon<BigReal>()));
    factor *= x.z * (x.gamma + k) / BigReal(k + 1);
    if (factor == 0) return sum;
    const BigReal rest = tail(x, k, factor);
    if (rest > epsilon<BigReal>() * size_of(sum.value)) continue;
    sum.error += rest;
    return sum;
  }
  throw std::runtime_error(fmt::format("the power series takes more than {} terms", most_terms));
}

}  // namespace fde
