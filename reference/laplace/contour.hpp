#pragma once

#include "laplace/contour_bound.hpp"
#include "numbers/real.hpp"

namespace fde {

// Inverse Laplace transform at time 1 by the trapezoidal rule on a parabola round the negative real axis
// (Weideman & Trefethen, Math. Comp. 76, 2007):
//   f = 1/(2 pi i) int e^s F(s) ds,  s(theta) = mu (1 + i theta)^2,  theta_k = (k + shift) h,  omega = 2 pi /
//   h.
//
// The only singularities in the strip |Im theta| < 1 are poles of F; each is corrected for exactly. With
//   m(theta) = 1 / (1 - e^(-2 pi i (theta/h - shift))),
// whose poles are the nodes, with residue h/(2 pi i), the residue theorem for (integrand * m) gives
//   f = trapezoidal sum + sum over the poles s* of Res(e^s F, s*) m(theta(s*)) + O(e^-omega),
// wherever the poles lie: m ~ 0 for a pole deep inside the parabola, which the sum has seen, and m ~ 1 for
// one outside, which it has not. What is left, e^-omega, comes from the branch point s = 0 at theta = i.
template <class Real>
class Contour {
 public:
  // One node of the upper half with its conjugate: f ~ sum of weight F(s) + conj(weight) F(conj s).
  struct Node {
    Complex<Real> s, log_s, weight;
  };

  // The sum ends where |e^s| is down to e^-depth.
  Contour(const Real& mu, const Real& omega, const Real& depth, bool half_step_shift);

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] const Real& omega() const { return omega_; }
  [[nodiscard]] const Real& share() const { return share_; }  // e^-mu
  [[nodiscard]] ContourShape shape() const;

  // Factor m of a pole, and how large it is against the loss of digits next to a node. The logarithm names
  // the sheet.
  [[nodiscard]] Complex<Real> pole_factor(const Complex<Real>& log_pole) const;
  // Poles within 1/omega of the branch point are one with it: correcting them apart would only lose digits.
  [[nodiscard]] bool at_branch_point(const Complex<Real>& log_pole) const;
  // Distance of a pole from the nearest node, in steps.
  [[nodiscard]] Real steps_to_node(const Complex<Real>& log_pole) const;

  // Estimate of what is neglected, for |F| on circles |s| = r without its poles.
  template <class Size>
  [[nodiscard]] Real discretisation(const Size& size_at) const {
    using std::exp;
    const Real near = mu_ / (omega_ * omega_), far = mu_ + mu_ + depth_;
    const Real at_branch = near * size_at(near) + mu_ * size_at(mu_);
    return Real(10) * (exp(-omega_) * at_branch + exp(-depth_) * far * size_at(far));
  }

 private:
  [[nodiscard]] Complex<Real> step_of(const Complex<Real>& log_pole) const;  // theta / h - shift

  Real mu_, omega_, depth_, shift_, share_;
  std::vector<Node> nodes_;
};

// Good to about that many decimal digits against the size of f, for F like s^exponent: the saddle of e^s
// s^exponent is at s = -exponent, and large exponents take long to fall off and turn it twice as fast there.
// Work with contour_precision(digits) digits. Call under a Precision; the reference is good until the next
// call.
const Contour<BigReal>& contour_for(int digits, double exponent = 0.0);
int contour_precision(int digits);

// Of the two long double contours, with nodes half a step apart, the one that stays farther away from the
// poles.
const Contour<long double>& contour_away_from(const std::vector<Complex<long double>>& log_poles);

extern template class Contour<long double>;
extern template class Contour<BigReal>;

}  // namespace fde
