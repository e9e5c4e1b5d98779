#pragma once

#include "laplace/contour.hpp"
#include "transfer_functions/linear_transform.hpp"

namespace fde {

// Values of the outputs, and t dx/dt of each: what a relative error of t does to it.
template <class Real>
struct LinearValues {
  std::vector<Sum<Real>> sums;
  std::vector<Complex<Real>> rates;
};

// The response of one group, a time > 0 after it started. With time measured in that unit it is a response at
// time 1, where the contours are: with p = s time a term c s^e of a numerator becomes c time^(-e-1) p^e, one
// of the denominator c time^-e p^e.
template <class Real>
class LinearResponse {
 public:
  using Group = typename RoundedTransform<Real>::Group;
  LinearResponse(const RoundedTransform<Real>& transform, const Group& group, const Real& time);

  // Adds the value of every output; the zeros are those of the denominator as it was before scaling.
  void add_to(LinearValues<Real>& values, const std::vector<Zero<Real>>& zeros, const Contour<Real>& contour);
  // Adds to the errors what the contour neglects.
  void add_discretisation(LinearValues<Real>& values, const Contour<Real>& contour);

 private:
  using Polynomial = typename RoundedTransform<Real>::Polynomial;
  // Of a sum of powers: its value, and a bound of its error in units of epsilon.
  struct Value {
    Complex<Real> value;
    Real error;
  };

  [[nodiscard]] Polynomial scaled(const Polynomial& polynomial, const Real& factor) const;
  void evaluate(const Complex<Real>& log_p, const Complex<Real>& p);
  [[nodiscard]] Value sum_of(const Polynomial& polynomial) const;
  // p P', and how that changes with log p: next to another zero it is small against its change.
  struct Slope {
    Complex<Real> value, change;
  };
  [[nodiscard]] Slope slope() const;
  // A simple zero of the scaled denominator, and the relative errors of it and of the slope there, in ulps.
  struct Pole {
    Complex<Real> log, value, slope;
    Real ulps, slope_ulps;
  };
  // Leaves the powers at the pole, with its error in theirs.
  [[nodiscard]] Pole at_pole(const Complex<Real>& estimate);
  void add_nodes(LinearValues<Real>& values, const Contour<Real>& contour);
  void add_residue(LinearValues<Real>& values, const Complex<Real>& estimate, const Contour<Real>& contour,
                   const Real& count);
  void add_circle(LinearValues<Real>& values, const Zero<Real>& zero, const Contour<Real>& contour,
                  const Real& count);
  void add_terms(LinearValues<Real>& values, const Complex<Real>& factor, const Real& ulps,
                 const Real& share) const;

  const RoundedTransform<Real>& transform_;
  Real log_time_, log_time_size_;
  std::vector<Real> time_powers_;
  Polynomial denominator_;
  std::vector<Polynomial> numerators_;

  // At the last p: its powers, with their moduli times their error in ulps.
  Complex<Real> p_;
  std::vector<Complex<Real>> powers_;
  std::vector<Real> errors_;
  Value characteristic_;
};

// Whether zeros that cannot be told apart in a long double are, after that time, so far out that e^p is
// anything between them: then no number of digits helps.
bool has_no_circle(const Zero<long double>& zero, long double log_time);

extern template class LinearResponse<long double>;
extern template class LinearResponse<BigReal>;

}  // namespace fde
