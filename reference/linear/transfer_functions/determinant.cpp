// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/transfer_functions/determinant.hpp"

#include <bit>

namespace fde::reference {
namespace {

bool is_fraction(const Coefficient& coefficient) {
  const Factor& factor = coefficient.begin()->first;
  return coefficient.size() == 1 && factor.power == 0 && factor.gamma == 1;
}

// Adds sign * a * b. Precondition: of two coefficients at least one is rational.
void add_product(GeneralizedPolynomial& sum, const GeneralizedPolynomial& a, const GeneralizedPolynomial& b,
                 int sign) {
  for (const auto& [left, of_left] : a) {
    for (const auto& [right, of_right] : b) {
      const bool plain = is_fraction(of_right);
      const Rational& scale = (plain ? of_right : of_left).begin()->second;
      add_term(sum, Rational(left + right), plain ? of_left : of_right, Rational(sign * scale));
    }
  }
}

}  // namespace

GeneralizedPolynomial determinant(const PolynomialMatrix& matrix) {
  // Minors of the rows so far, by the bit set of their columns.
  std::map<unsigned, GeneralizedPolynomial> minors{{0U, {}}}, next;
  add_term(minors[0U], 0, Rational(1));
  for (const auto& row : matrix) {
    next.clear();
    for (const auto& [columns, minor] : minors) {
      for (std::size_t j = 0; j < row.size(); ++j) {
        if ((columns >> j & 1U) != 0U || row[j].empty()) continue;
        const int sign = std::popcount(columns >> j) % 2 == 0 ? 1 : -1;
        add_product(next[columns | 1U << j], minor, row[j], sign);
      }
    }
    std::erase_if(next, [](const auto& entry) { return entry.second.empty(); });
    minors.swap(next);
  }
  return minors.empty() ? GeneralizedPolynomial{} : minors.begin()->second;
}

}  // namespace fde::reference
