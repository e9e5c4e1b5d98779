// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "certificate/enclosure.hpp"

namespace fde::reference::certificate {

// Successive terms |z^k / Gamma(alpha k + beta)| have the ratio r_k = |z| Gamma(x)/Gamma(x + alpha),
// x = alpha k + beta, which decreases with k once x > 0, because log Gamma is convex. So the remainder after
// a term t of ratio r < 1 is at most |t| r/(1 - r).
Ball power_series(const Arguments& x) {
  if (acb_is_zero(x.z.get()) != 0) return reciprocal_gamma(x.beta);
  constexpr int most_terms = 100'000;
  Ball sum, last_head;
  double largest = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < most_terms; ++k) {
    const Ball argument = x.alpha * Ball(k) + x.beta, head = reciprocal_gamma(argument);
    // By squarings: a product with z for each k would rotate the rectangle and enlarge it each time (wrapping
    // effect).
    const Ball term = power(x.z, static_cast<unsigned long>(k)) * head;
    sum = sum + term;
    const double size = log2_upper_bound(term);
    largest = std::max(largest, size);
    const bool small = size < largest - static_cast<double>(WorkingBits::get());
    if (small && argument - x.alpha > Ball(0.0)) {
      const Ball ratio = abs(x.z) * head / last_head;
      if (ratio < Ball(0.99)) {
        sum.widen(abs(term) * ratio / (Ball(1.0) - ratio));
        return sum;
      }
    }
    last_head = head;
  }
  throw std::runtime_error("the power series does not end");
}

SeriesEffort series_effort(const Arguments& x, long bits) {
  const double alpha = x.alpha.mid().real(), beta = x.beta.mid().real(), size = std::abs(x.z.mid());
  if (size == 0.0) return {1.0, 0.0};
  const double root = std::pow(size, 1.0 / alpha);  // the largest terms are near alpha k + beta = root
  const auto log2_term = [&](double k) {
    return (k * std::log(size) - std::lgamma(std::max(alpha * k + beta, 1.0))) / std::numbers::ln2;
  };
  const double peak = std::max(0.0, (root - beta) / alpha), top = std::max(log2_term(peak), log2_term(0.0));
  if (!(peak < 1e6)) return {1e9, 1e9};
  double terms = peak + 4.0;
  while (terms < 1e7 && log2_term(terms) > top - static_cast<double>(bits)) terms *= 1.1;
  const double turn = std::arg(x.z.mid()) / alpha;
  const double growth = std::abs(turn) < std::numbers::pi ? std::max(0.0, root * std::cos(turn)) : 0.0;
  return {terms, std::max(0.0, (root - growth) / std::numbers::ln2)};
}

}  // namespace fde::reference::certificate
