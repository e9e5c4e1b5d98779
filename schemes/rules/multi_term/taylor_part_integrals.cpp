// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/multi_term/taylor_part_integrals.hpp"

#include <algorithm>
#include <cmath>

namespace fde {

TaylorPartIntegrals::TaylorPartIntegrals(const Chain& chain) {
  const double leading = chain.leading().order;
  const auto& initial = chain.initial();
  for (Eigen::Index row = 0; row < chain.size(); ++row) {
    const double node = chain.nodes()[static_cast<std::size_t>(row)];
    for (std::size_t j = 0; j < initial.size(); ++j) {
      const auto degree = static_cast<double>(j);
      if (initial[j] == 0.0) continue;
      // D^v t^j = 0 for j < ceil(v); otherwise D^v t^j / j! = t^(j-v) / Gamma(j-v+1).
      const auto add = [&](double order, double coefficient, Vec Power::*of) {
        const double exponent = degree - order;
        (power(exponent, chain.size()).*of)[row] += coefficient * initial[j] / std::tgamma(exponent + 1.0);
      };
      if (degree >= std::ceil(node)) add(node, 1.0, &Power::derivatives);
      for (const auto& [coefficient, order] : chain.terms()) {
        if (degree >= std::ceil(order))
          add(order - leading + node, coefficient / chain.leading().coefficient, &Power::integrals);
      }
    }
  }
}

TaylorPartIntegrals::Power& TaylorPartIntegrals::power(double exponent, Eigen::Index rows) {
  const int whole = static_cast<int>(std::floor(exponent));
  const double fraction = exponent - whole;
  const auto found = std::ranges::find_if(
      powers_, [&](const Power& other) { return other.fraction == fraction && other.whole == whole; });
  if (found != powers_.end()) return *found;
  const auto place = std::ranges::upper_bound(powers_, fraction, {}, &Power::fraction);
  return *powers_.insert(place, {fraction, whole, Vec::Zero(rows), Vec::Zero(rows)});
}

void TaylorPartIntegrals::at(double t, Out derivatives, Out integrals) const {
  derivatives.setZero();
  integrals.setZero();
  double fraction = 0.0, root = 1.0;
  for (const auto& power : powers_) {
    if (power.fraction != fraction) root = std::pow(t, fraction = power.fraction);
    double value = root;
    for (int k = 0; k < power.whole; ++k) value *= t;
    derivatives += value * power.derivatives;
    integrals += value * power.integrals;
  }
}

}  // namespace fde
