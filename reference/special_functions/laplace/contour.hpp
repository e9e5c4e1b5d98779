// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "fdebench/reference/special_functions/laplace/contour_bound.hpp"
#include "fdebench/reference/special_functions/numbers/bounded.hpp"
#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::reference {

// Inverse Laplace transform at time 1 by the trapezoidal rule on a parabola round the negative real axis
// (Weideman & Trefethen, Math. Comp. 76, 2007):
//   f = 1/(2 pi i) int e^s F(s) ds,  s(theta) = mu (1 + i theta)^2,  theta_k = (k + shift) h,
//   omega = 2 pi / h.
//
// The only singularities in the strip |Im theta| < 1 are poles of F, and each is corrected for exactly. With
//   m(theta) = 1 / (1 - e^(-2 pi i (theta/h - shift))),
// whose poles are the nodes, with residue h/(2 pi i), the residue theorem for (integrand * m) gives
//   f = trapezoidal sum + sum over the poles s* of Res(e^s F, s*) m(theta(s*)) + O(e^-omega),
// wherever the poles lie: m ~ 0 for a pole deep inside the parabola, whose residue the sum contains, and
// m ~ 1 for one outside. The error e^-omega comes from the branch point s = 0 at theta = i.
template <class Real>
class Contour {
 public:
  // One node of the upper half with its conjugate: f ~ sum of weight F(s) + conj(weight) F(conj s).
  struct Node {
    Complex<Real> s, log_s, weight;
  };

  // The sum is truncated where |e^s| has decayed to e^-depth.
  Contour(const Real& mu, const Real& omega, const Real& depth, bool half_step_shift);

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] const Real& omega() const { return omega_; }
  [[nodiscard]] const Real& exp_minus_mu() const { return exp_minus_mu_; }  // e^-mu
  [[nodiscard]] ContourShape shape() const;

  // Factor m of the pole with this logarithm, whose imaginary part determines the sheet.
  [[nodiscard]] Complex<Real> pole_factor(const Complex<Real>& log_pole) const;
  // Whether |theta - i| < 1/omega for the pole: it then counts as part of the branch point, as a separate
  // correction would only lose digits.
  [[nodiscard]] bool at_branch_point(const Complex<Real>& log_pole) const;
  // Distance of a pole from the nearest node, in steps.
  [[nodiscard]] Real steps_to_node(const Complex<Real>& log_pole) const;

  // Estimate of the discretisation error; size_at(r) is |F| without its poles on the circle |s| = r.
  template <class Size>
  [[nodiscard]] Real discretisation_error(const Size& size_at) const {
    using std::exp;
    const Real near = mu_ / (omega_ * omega_), far = mu_ + mu_ + depth_;
    const Real at_branch = near * size_at(near) + mu_ * size_at(mu_);
    return Real(10) * (exp(-omega_) * at_branch + exp(-depth_) * far * size_at(far));
  }

 private:
  [[nodiscard]] Complex<Real> step_of(const Complex<Real>& log_pole) const;  // theta / h - shift

  Real mu_, omega_, depth_, shift_, exp_minus_mu_;
  std::vector<Node> nodes_;
};

// A contour with an error of about 10^-digits relative to the size of f, for F like s^exponent: the saddle
// point of e^s s^exponent is at s = -exponent, and for large exponents the integrand decays late and
// oscillates twice as fast. F is to be evaluated with contour_precision(digits) digits. Precondition: a
// Precision is in force. The returned reference is valid until the next call.
const Contour<BigReal>& contour_for(int digits, double exponent = 0.0);
int contour_precision(int digits);

// Of two long double contours, with nodes half a step apart, the one whose nodes are farther from the poles.
const Contour<long double>& contour_away_from(const std::vector<Complex<long double>>& log_poles);

extern template class Contour<long double>;
extern template class Contour<BigReal>;

// increase_digits() for sums on contour_for(). `extra` working digits are added to contour_precision(), for
// the phase of e^s at poles with large |s|. Precondition of both functions: a Precision is in force.
// Values on contour_for(digits); called with the Precision for it in force.
using EvaluateAt = std::function<std::vector<BoundedSum<BigReal>>(int digits)>;

// Raises the working digits until every value has the wanted relative accuracy or max_working_digits() is
// reached. The bounds are estimates: 4 times the difference of two contours, for `digits` and for clearly
// more digits, plus rounding. A value more than 40 digits smaller than its summands counts as zero: its
// accuracy is then relative to their size.
std::vector<Bounded<BigReal>> increase_digits_by_comparison(int wanted_digits, int extra,
                                                            const EvaluateAt& evaluate);

// The same for one value whose BoundedSum::error is a bound of the whole error, and which never counts as
// zero. Throws std::runtime_error where max_working_digits() does not suffice.
Bounded<BigReal> increase_digits_by_bound(int wanted_digits, int extra,
                                          const std::function<BoundedSum<BigReal>(int digits)>& evaluate);

}  // namespace fde::reference
