// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/laplace/sheets.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fde::reference {

std::vector<RootOnSheet> roots_on_sheet(long double alpha, std::complex<long double> log_z) {
  constexpr long double half_turn = std::numbers::pi_v<long double>, hair = 1e-9L, largest = 11000.0L;
  const bool whole = std::floor(alpha) == alpha;
  std::vector<RootOnSheet> roots;
  for (int k = -3; k <= 3; ++k) {
    const std::complex<long double> root = log_on_sheet<long double>(log_z, k) / alpha;
    if (root.imag() > half_turn + hair || root.imag() < -half_turn + (whole ? hair : -hair)) continue;
    auto value = std::polar(std::exp(std::min(root.real(), largest)), root.imag());
    if (std::abs(std::abs(root.imag()) - half_turn) <= hair) value.imag(0.0L);
    roots.push_back({root, value});
  }
  return roots;
}

}  // namespace fde::reference
