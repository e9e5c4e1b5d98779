// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/linear/transfer_functions/linear_transform.hpp"
#include "fdebench/reference/special_functions/laplace/contour.hpp"

namespace fde::reference {

// Values of the outputs, and t dx/dt of each: its sensitivity to a relative error of t.
template <class Real>
struct LinearValues {
  std::vector<BoundedSum<Real>> sums;
  std::vector<Complex<Real>> rates;
};

// The powers of a transform at each node of a contour, in the order of its table. They do not depend on the
// time, because LinearResponse scales the coefficients in place of the nodes.
template <class Real>
using NodePowers = std::vector<std::vector<Complex<Real>>>;
template <class Real>
NodePowers<Real> powers_at_nodes(const RoundedTransform<Real>& transform, const Contour<Real>& contour);

// The response of one group at `time` > 0 after its start, scaled to a response at time 1, for which the
// contours are: with p = s time, a term c s^e of a numerator becomes c time^(-e-1) p^e, a term of the
// denominator c time^-e p^e.
template <class Real>
class LinearResponse {
 public:
  using Group = typename RoundedTransform<Real>::Group;
  LinearResponse(const RoundedTransform<Real>& transform, const Group& group, const Real& time);

  // Adds the value of every output; `zeros` are the zeros of the denominator before scaling, and `powers`
  // those at the nodes of the contour.
  void add_to(LinearValues<Real>& values, const std::vector<Zero<Real>>& zeros, const Contour<Real>& contour,
              const NodePowers<Real>& powers);
  // Adds an estimate of the discretisation error of the contour to the errors.
  void add_discretisation(LinearValues<Real>& values, const Contour<Real>& contour);

 private:
  using Polynomial = typename RoundedTransform<Real>::Polynomial;
  // Value of a sum of powers, and a bound of its error in units of epsilon.
  struct Value {
    Complex<Real> value;
    Real error;
  };

  [[nodiscard]] Polynomial scaled(const Polynomial& polynomial, const Real& factor) const;
  void evaluate(const Complex<Real>& log_p, const Complex<Real>& p);
  // The same with powers_ given.
  void evaluate_sums(const Complex<Real>& log_p, const Complex<Real>& p);
  [[nodiscard]] Value sum_of(const Polynomial& polynomial) const;
  // p P'(p) and its derivative with respect to log p: next to another zero, p P' is much smaller.
  struct Slope {
    Complex<Real> value, change;
  };
  [[nodiscard]] Slope slope() const;
  // A simple zero of the scaled denominator, the slope there, and the relative errors of both, in ulps.
  struct Pole {
    Complex<Real> log, value, slope;
    Real ulps, slope_ulps;
  };
  // Afterwards powers_ and errors_ are those at the pole; errors_ includes the error of the pole.
  [[nodiscard]] Pole at_pole(const Complex<Real>& estimate);
  void add_nodes(LinearValues<Real>& values, const Contour<Real>& contour, const NodePowers<Real>& powers);
  void add_residue(LinearValues<Real>& values, const Complex<Real>& estimate, const Contour<Real>& contour,
                   const Real& count);
  void add_cluster_residues(LinearValues<Real>& values, const Zero<Real>& zero, const Contour<Real>& contour,
                            const Real& count);
  void add_terms(LinearValues<Real>& values, const Complex<Real>& factor, const Real& ulps,
                 const Real& share) const;

  const RoundedTransform<Real>& transform_;
  Real log_time_, log_time_size_;
  std::vector<Real> time_powers_;
  Polynomial denominator_;
  std::vector<Polynomial> numerators_;

  // At the last p: its powers, and their absolute errors in units of epsilon.
  Complex<Real> p_;
  std::vector<Complex<Real>> powers_;
  std::vector<Real> errors_;
  Value characteristic_;
};

// Whether the zeros of a cluster, not separated in long double, are at that time so far out that e^p varies
// too much between them for a circle around them: more digits do not help then.
bool is_unresolvable_cluster(const Zero<long double>& zero, long double log_time);

extern template NodePowers<long double> powers_at_nodes(const RoundedTransform<long double>&,
                                                        const Contour<long double>&);
extern template NodePowers<BigReal> powers_at_nodes(const RoundedTransform<BigReal>&,
                                                    const Contour<BigReal>&);
extern template class LinearResponse<long double>;
extern template class LinearResponse<BigReal>;

}  // namespace fde::reference
