// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace fde {

// The generating function of a fractional linear multistep method (Lubich), by its coefficients:
//   omega(zeta) = (1-zeta)^(-g) (base(zeta) / denominator)^(exponent g) q(1-zeta),
// where q(u) = sum_i u^i sum_k corrections[i][k] g^k / 24. omega is for an integral of order g and step
// size 1.
struct MultistepRule {
  int rate;
  std::array<int, 6> base{1};
  int denominator = 1;
  int exponent = -1;
  std::array<std::array<int, 3>, 3> corrections{{{24}}};
  double decay = 0.0;  // the coefficients of omega (1-zeta)^g decay like decay^k; 0: at most 3 are not 0
};

// The coefficients of W = P^a Q^b up to zeta^(count-1), from the recurrence of P Q W' = (a P' Q + b P Q') W.
// Precondition: the polynomials P and Q are 1 at 0.
template <class Real>
std::vector<Real> power_product(const std::vector<Real>& p, const Real& a, const std::vector<Real>& q,
                                const Real& b, std::size_t count) {
  std::vector<Real> product(p.size() + q.size() - 1, Real(0)), slope(product.size(), Real(0));
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) {
      const Real term = p[i] * q[j];
      product[i + j] += term;
      if (i + j > 0) slope[i + j - 1] += (a * Real(i) + b * Real(j)) * term;
    }
  }
  std::vector<Real> w(count, Real(0));
  if (count > 0) w[0] = Real(1);
  for (std::size_t n = 1; n < count; ++n) {
    Real sum(0);
    for (std::size_t k = 0; k + 1 < product.size() && k < n; ++k) {
      sum += (slope[k] - product[k + 1] * Real(n - 1 - k)) * w[n - 1 - k];
    }
    w[n] = sum / Real(n);
  }
  return w;
}

// The coefficients of base / base(0).
template <class Real>
std::vector<Real> scaled_base(const MultistepRule& rule) {
  std::size_t size = rule.base.size();
  while (size > 1 && rule.base[size - 1] == 0) --size;
  std::vector<Real> scaled(size);
  for (std::size_t i = 0; i < size; ++i) scaled[i] = Real(rule.base[i]) / Real(rule.base[0]);
  return scaled;
}

// The coefficients of q(1 - zeta) in powers of zeta.
template <class Real>
std::vector<Real> correction(const MultistepRule& rule, const Real& g) {
  std::array<Real, 3> in_u;
  std::size_t size = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& terms = rule.corrections[i];
    in_u[i] = (Real(terms[0]) + g * (Real(terms[1]) + g * Real(terms[2]))) / Real(24);
    if (terms != std::array<int, 3>{}) size = i + 1;
  }
  std::vector<Real> in_zeta{in_u[0] + in_u[1] + in_u[2], -in_u[1] - Real(2) * in_u[2], in_u[2]};
  in_zeta.resize(size);
  return in_zeta;
}

// The coefficients of the power series w times q / q(0), truncated to the size of w.
template <class Real>
std::vector<Real> corrected(const MultistepRule& rule, const Real& g, const std::vector<Real>& w) {
  const auto q = correction(rule, g);
  if (q.size() == 1) return w;
  std::vector<Real> product(w.size(), Real(0));
  for (std::size_t n = 0; n < w.size(); ++n) {
    for (std::size_t i = 0; i < q.size() && i <= n; ++i) product[n] += w[n - i] * q[i] / q[0];
  }
  return product;
}

// The coefficients of omega / omega(0): the weights of f_n, f_(n-1), ..., scaled so that f_n has weight 1.
template <class Real>
std::vector<Real> multistep_weights(const MultistepRule& rule, const Real& g, std::size_t count) {
  const std::vector<Real> difference{Real(1), Real(-1)};
  return corrected(
      rule, g, power_product<Real>(difference, -g, scaled_base<Real>(rule), Real(rule.exponent) * g, count));
}

// The coefficients of (1-zeta)^g omega / omega(0): their convolution with the Grunwald-Letnikov weights gives
// multistep_weights.
template <class Real>
std::vector<Real> multistep_filter(const MultistepRule& rule, const Real& g, std::size_t count) {
  return corrected(
      rule, g,
      power_product<Real>({Real(1)}, Real(0), scaled_base<Real>(rule), Real(rule.exponent) * g, count));
}

}  // namespace fde
