// SPDX-License-Identifier: MIT
#include "certificate/enclosure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace fde::reference::certificate {
namespace {

bool is_integer(const Ball& x) { return acb_is_int(x.get()) != 0; }

// A term of the series costs one evaluation of Gamma, a point of the integral three complex exponentials.
constexpr double most_series_terms = 800.0;

Method method_for(const Arguments& x, long bits) {
  const bool small = std::abs(x.z.mid()) <= 1.0;
  if (is_integer(x.alpha) && is_integer(x.beta) && !small) return Method::residues;
  const auto [terms, lost] = series_effort(x, bits);
  return terms <= most_series_terms && lost < 2.0 * static_cast<double>(bits) ? Method::power_series
                                                                              : Method::hankel;
}

Ball evaluate_once(const Arguments& x, Method method) {
  const Ball value = method == Method::power_series ? power_series(x)
                     : method == Method::residues   ? integer_residues(x)
                                                    : hankel_integral(x);
  return x.real() ? real(value) : value;
}

}  // namespace

Ball enclose(const Arguments& x, int digits, Method method) {
  const long goal = std::lround(std::ceil(digits * std::numbers::ln10 / std::numbers::ln2));
  if (method == Method::automatic) method = method_for(x, goal);
  constexpr long most_bits = 20'000, guard = 24;
  long bits = goal + guard;
  if (method == Method::power_series) bits += std::lround(std::min(series_effort(x, goal).lost_bits, 1e4));
  while (bits <= most_bits) {
    const WorkingBits scope(bits);
    Ball value = evaluate_once(x, method);
    const long accuracy = value.accuracy();
    if (accuracy >= goal) return value;
    bits += accuracy > 0 ? goal - accuracy + guard : bits;
  }
  throw std::runtime_error(
      fmt::format("certificate: no {} digits of the value within {} bits", digits, most_bits));
}

Ball enclose(double alpha, double beta, std::complex<double> z, int digits, Method method) {
  return enclose({Ball(alpha), Ball(beta), Ball(z)}, digits, method);
}

}  // namespace fde::reference::certificate
