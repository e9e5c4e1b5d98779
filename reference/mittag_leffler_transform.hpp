#pragma once

#include "contour.hpp"

namespace fde {

// E_{alpha,beta}(z) is the inverse Laplace transform of s^(alpha-beta) / (s^alpha - z) at time 1.
template <class Real>
struct MittagLefflerArguments {
  Real alpha, beta;
  Complex<Real> z;

  [[nodiscard]] bool real() const { return imag_part<Real>(z) == 0; }
  // All powers of s in the transform are whole: no branch cut, and the poles are everything.
  [[nodiscard]] bool cut_free() const { return is_whole(alpha) && is_whole(beta) && beta <= alpha; }
};

template <class Real>
using Poles = std::vector<Complex<Real>>;  // logarithms, which name the sheet

// The poles s*^alpha = z up to a little beyond the cut |arg s| = pi.
template <class Real>
Poles<Real> poles_of(const MittagLefflerArguments<Real>& x) {
  using std::abs, std::log;
  const Complex<Real> log_z = log(x.z);
  const Real reach = x.alpha * (pi<Real>() + Real(0.1));
  Poles<Real> poles;
  for (int k = -3; k <= 3; ++k) {
    const Real argument = imag_part<Real>(log_z) + 2 * k * pi<Real>();
    if (abs(argument) <= reach)
      poles.emplace_back(Real(real_part<Real>(log_z) / x.alpha), Real(argument / x.alpha));
  }
  return poles;
}

// Adds Res(e^s F, s*) = (1/alpha) e^(s* + (1-beta) log s*) times a factor known to that many ulps.
template <class Real>
void add_residue(Sum<Real>& sum, const MittagLefflerArguments<Real>& x, const Complex<Real>& log_pole,
                 const Complex<Real>& factor, const Real& factor_ulps) {
  using std::abs, std::exp;
  const Complex<Real> pole = x.alpha == 1 ? x.z : exp(log_pole);
  if (real_part<Real>(pole) < -8 / epsilon<Real>()) return;  // e^s* is nothing, and s* may have overflowed
  const Real power = 1 - x.beta;
  const Real pole_ulps = x.alpha == 1 ? Real(1) : 1 + size_of(log_pole);
  const Complex<Real> exponent = pole + power * log_pole;
  if (exp_overflows(pole, Real(pole_ulps * epsilon<Real>()))) {
    sum.add_infinite(exp(Complex<Real>(Real(0), imag_part<Real>(exponent))), real_part<Real>(pole));
    return;
  }
  const Complex<Real> residue = exp(exponent) / x.alpha;
  const Real ulps = (size_of(pole) + factor_ulps) * pole_ulps + abs(power) * size_of(log_pole) + 4;
  sum.add(residue * factor, ulps * epsilon<Real>());
}

// Cut free: E = sum over the alpha roots s* of s*^alpha = z of the residues.
template <class Real>
Sum<Real> sum_of_residues(const MittagLefflerArguments<Real>& x) {
  using std::log;
  const Complex<Real> log_z = log(x.z);
  Sum<Real> sum;
  for (int k = 0; k < x.alpha; ++k) {
    const Complex<Real> turned(real_part<Real>(log_z), Real(imag_part<Real>(log_z) + 2 * k * pi<Real>()));
    add_residue(sum, x, Complex<Real>(turned / x.alpha), Complex<Real>(1), Real(0));
  }
  return sum;
}

// The transform after peeling off the head of the asymptotic expansion, exact for every m >= 0:
//   E_{alpha,beta}(z) = -sum_{k=1}^m z^-k / Gamma(beta - alpha k) + z^-m E_{alpha,beta-m alpha}(z).
// What is left has the size of the terms not peeled: no cancellation where beta = alpha makes the first one
// vanish.
template <class Real>
Sum<Real> peel(const MittagLefflerArguments<Real>& x, int m) {
  using std::abs;
  Sum<Real> sum;
  Complex<Real> power(1);
  for (int k = 1; k <= m; ++k) {
    power /= x.z;
    const Real argument = x.beta - k * x.alpha;
    sum.add(-power * reciprocal_gamma(argument), (8 + 4 * abs(argument)) * epsilon<Real>());
  }
  return sum;
}

// s^-beta at a node, from s where a product or a quotient does.
template <class Real>
Complex<Real> power_minus_beta(const MittagLefflerArguments<Real>& x,
                               const typename Contour<Real>::Node& node) {
  using std::exp;
  if (x.beta == 0) return Complex<Real>(1);
  if (x.beta == 1) return Real(1) / node.s;
  if (x.beta == 2) return Real(1) / (node.s * node.s);
  return exp(-x.beta * node.log_s);
}

template <class Real>
Sum<Real> on_contour(const MittagLefflerArguments<Real>& x, const Contour<Real>& contour,
                     const Poles<Real>& poles, int peeled) {
  using std::abs, std::conj, std::exp;
  Sum<Real> sum = peel(x, peeled);
  Complex<Real> scale(1);
  for (int k = 0; k < peeled; ++k) scale /= x.z;
  const bool equal = x.beta == x.alpha;
  const Real powers = (2 + peeled) * x.alpha + abs(x.beta);
  for (const auto& node : contour.nodes()) {
    const Complex<Real> s_alpha = exp(x.alpha * node.log_s);
    Complex<Real> weight = equal ? node.weight : node.weight * s_alpha * power_minus_beta(x, node);
    for (int k = 0; k < peeled; ++k) weight *= s_alpha;
    const Complex<Real> denominator = s_alpha - x.z;
    const Real ulps = 3 + powers * size_of(node.log_s);
    const auto loss = [&](const Complex<Real>& difference) {  // in s^alpha - z
      return Real(ulps * (1 + size_of(s_alpha) / size_of(difference)) * epsilon<Real>());
    };
    const Complex<Real> term = scale * (weight / denominator);
    if (x.real()) {
      const Complex<Real> with_conjugate(Real(2 * real_part<Real>(term)));
      sum.add(with_conjugate, Real(2 * size_of(term)), loss(denominator), contour.share());
      continue;
    }
    const Complex<Real> mirrored = conj(s_alpha) - x.z;
    sum.add(term, loss(denominator), contour.share());
    sum.add(scale * (conj(weight) / mirrored), loss(mirrored), contour.share());
  }
  for (const auto& pole : poles) {
    if (contour.at_branch_point(pole)) continue;
    const Complex<Real> factor = contour.pole_factor(pole);
    add_residue(sum, x, pole, factor, Real(contour.omega() * size_of(Complex<Real>(factor - Real(1)))));
  }
  return sum;
}

}  // namespace fde
