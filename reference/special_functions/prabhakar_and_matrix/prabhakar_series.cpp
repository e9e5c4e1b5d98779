// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <stdexcept>

#include "fdebench/reference/special_functions/numbers/log_gamma.hpp"
#include "fdebench/reference/special_functions/numbers/reciprocal_gamma.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar_transform.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::reference {
namespace {

// A bound of the sum of the terms after the k-th, infinite where there is none yet; next is
// (gamma)_{k+1} z^{k+1} / (k+1)!. From there on |(gamma + k) / (k + 1)| is at most its value there, or 1. And
//   Gamma(x + alpha) / Gamma(x) >= (x - 1)^alpha, for psi(x) >= log x - 1/x >= log(x - 1);
//   1/Gamma(x) <= 1.13, x >= 0.
BigReal tail(const PrabhakarArguments& x, int k, const BigComplex& next) {
  const BigReal argument = x.alpha * (k + 1) + x.beta, growing = x.gamma + k + 1;
  const BigReal power = abs(x.z) * std::max(BigReal(1), BigReal(abs(growing) / (k + 2)));
  const BigReal ratio = argument < 2 ? power : BigReal(power * pow(BigReal(argument - 1), -x.alpha));
  if (argument < 0 || growing <= 0 || ratio > 0.9) return {std::numeric_limits<double>::infinity()};
  constexpr double upwards = 1.01;
  const BigReal first = argument < 2
                            ? BigReal(1.13)
                            : BigReal(upwards * exp(BigReal(-log_gamma(argument.convert_to<double>()))));
  return norm1(next) * first / (1 - ratio);
}

}  // namespace

BoundedSum<BigReal> prabhakar_series(const PrabhakarArguments& x) {
  constexpr int most_terms = 200000;
  BoundedSum<BigReal> sum;
  BigComplex factor(1);  // (gamma)_k z^k / k!
  BigReal factor_ulps(0);
  for (int k = 0; k < most_terms; ++k) {
    report_progress(static_cast<std::size_t>(k));
    // for derivatives, x.beta is itself a sum beta + (gamma - 1) alpha
    const BigReal argument = x.alpha * k + x.beta, size = x.alpha * (k + 2 * abs(x.gamma)) + abs(x.beta);
    const BigReal ulps = factor_ulps + abs(argument) * (2 + 2 * log1p(abs(argument)));
    add_reciprocal_gamma(sum, factor, argument, size, ulps);
    // As for the arguments of Gamma, gamma + k within rounding of 0 is 0.
    const BigReal growing = x.gamma + k, rounding = 2 * (abs(x.gamma) + k);
    if (abs(growing) <= rounding * epsilon<BigReal>() || x.z == 0) return sum;
    factor *= x.z * growing / BigReal(k + 1);
    factor_ulps += 6 + rounding / abs(growing);
    const BigReal rest = tail(x, k, factor);
    if (rest > epsilon<BigReal>() * norm1(sum.value)) continue;
    sum.error += rest;
    return sum;
  }
  throw std::runtime_error(fmt::format("the power series takes more than {} terms", most_terms));
}

}  // namespace fde::reference
