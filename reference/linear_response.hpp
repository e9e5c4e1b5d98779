#pragma once

#include "contour.hpp"
#include "linear_transform.hpp"

namespace fde {

// The response of one group of loads, and of the initial values if they act with it, a time > 0 after it
// started. With time measured in that unit it is a response at time 1, where the contours are: with p = s
// time the transform is
//   time^-delta p^delta [G + sum_k u_k N_k] / P,  c_i -> c_i time^(-o_i), u_k -> u_k time^k, load -> load
//   time^power.
template <class Real>
class LinearResponse {
 public:
  LinearResponse(const LinearTransform<Real>& transform, const typename LinearTransform<Real>::Group& group,
                 const Real& time);

  // Adds the value of every output; the zeros are those of P as it was before scaling.
  void add_to(std::vector<Sum<Real>>& sums, const std::vector<Zero<Real>>& zeros,
              const Contour<Real>& contour);
  // Adds to the errors what the contour neglects.
  void add_discretisation(std::vector<Sum<Real>>& sums, const Contour<Real>& contour);

 private:
  void evaluate(const Complex<Real>& log_p, const Complex<Real>& p);
  void combine(const Complex<Real>& p);
  void add_nodes(std::vector<Sum<Real>>& sums, const Contour<Real>& contour);
  void add_residue(std::vector<Sum<Real>>& sums, const Complex<Real>& log_pole, const Contour<Real>& contour);
  void add_circle(std::vector<Sum<Real>>& sums, const Zero<Real>& zero, const Contour<Real>& contour);
  void add_terms(std::vector<Sum<Real>>& sums, const Complex<Real>& factor, const Real& ulps,
                 const Real& share) const;

  const LinearTransform<Real>& transform_;
  Real log_time_;
  std::vector<Complex<Real>> coefficients_, initial_;
  std::vector<std::pair<Real, std::size_t>> loads_;
  std::vector<Real> output_scales_;  // time^-delta

  // At the last p: its powers; P, p P' and the numerators; sums of moduli where terms may cancel.
  std::vector<Complex<Real>> powers_;
  Complex<Real> characteristic_, slope_;
  Real characteristic_size_, largest_term_;
  std::vector<Complex<Real>> numerators_;
  std::vector<Real> numerator_sizes_;
};

extern template class LinearResponse<long double>;
extern template class LinearResponse<BigReal>;

}  // namespace fde
